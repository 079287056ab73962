FROM python:3.11-slim AS install
WORKDIR /source
COPY . .
RUN python -m venv /opt/parmech \
    && /opt/parmech/bin/pip install --no-cache-dir --constraint constraints.txt .

FROM python:3.11-slim
# The home is the data volume: the database, and the caches of compiled kernels and fonts.
RUN useradd --uid 10001 --create-home --home-dir /data parmech
COPY --from=install /opt/parmech /opt/parmech
ENV PATH=/opt/parmech/bin:$PATH PYTHONUNBUFFERED=1
USER parmech
WORKDIR /data
VOLUME /data
EXPOSE 8000
CMD ["parmech", "serve", "--host", "0.0.0.0", "--port", "8000", "--data", "/data"]
