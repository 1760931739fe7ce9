# A machine with all that the course needs, for a devcontainer or to try it on: docker build -t frame-by-frame . Then
# docker run --rm -it frame-by-frame, and ./course list. Packages are those of ./course setup.
FROM debian:bookworm AS tools
RUN apt-get update && apt-get install --yes --no-install-recommends ca-certificates git
WORKDIR /frame-by-frame
COPY course CMakeLists.txt CMakePresets.json ./
COPY cmake cmake
COPY tools/setup tools/setup
RUN ./course setup --yes

FROM tools
COPY . .
RUN ./course --yes
CMD ["bash"]
