# A server for others. docs/hosting.md says how it is built and run.
FROM python:3.13-slim AS build
RUN python -m pip install --quiet --root-user-action=ignore --target=/uv uv
WORKDIR /source
COPY . .
ENV UV_PROJECT_ENVIRONMENT=/opt/softrod UV_COMPILE_BYTECODE=1 UV_PYTHON_DOWNLOADS=never
RUN /uv/bin/uv sync --quiet --no-dev --no-editable

FROM python:3.13-slim
COPY --from=build /opt/softrod /opt/softrod
RUN useradd --uid 10001 --home-dir /data --no-create-home softrod \
    && install --directory --owner=softrod --group=softrod --mode=700 /data
# Whatever is written is in the user's home, which is the volume: scenes, classes and machine code.
ENV HOME=/data PATH=/opt/softrod/bin:$PATH PYTHONUNBUFFERED=1
WORKDIR /data
USER softrod
# A new volume begins with this. On another processor it is compiled once more, and kept there.
RUN python -m sim.compiling.precompile all
VOLUME /data
EXPOSE 8080
HEALTHCHECK --interval=30s --timeout=10s --start-period=20s \
    CMD ["python", "-c", "import urllib.request as r; r.urlopen('http://127.0.0.1:8080/', timeout=8)"]
ENTRYPOINT ["softrod"]
CMD ["--host", "0.0.0.0", "--no-open"]
