package org.pendant.desktop.scene.gl;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import org.lwjgl.system.MemoryUtil;
import org.lwjgl.system.linux.DynamicLinkLoader;

/**
 * System library: where the dynamic linker of Linux finds a library by its name.
 *
 * <p>LWJGL asks that for each library that it is told the name of, by {@code dl_iterate_phdr} with
 * {@code dlclose} in its callback. Where another thread opens a library at that moment, such as the
 * JVM for a window, both wait for each other for ever (seen with LWJGL 3.4.3 and glibc 2.36). A
 * library that is told by its path is not asked for.
 */
final class SystemLibrary {
  private static final Path MAPPED = Path.of("/proc/self/maps");

  private SystemLibrary() {}

  /**
   * Loads a library, which stays, and tells where it is.
   *
   * @param name such as {@code libEGL.so.1}
   * @return empty if it cannot be loaded, or its place cannot be told
   */
  static Optional<Path> path(String name) {
    if (DynamicLinkLoader.dlopen(name, DynamicLinkLoader.RTLD_LAZY) == MemoryUtil.NULL) {
      return Optional.empty();
    }
    try (Stream<String> lines = Files.lines(MAPPED)) {
      return lines
          .filter(line -> line.indexOf('/') >= 0)
          .map(line -> Path.of(line.substring(line.indexOf('/'))))
          .filter(file -> file.getFileName().toString().startsWith(name))
          .findFirst();
    } catch (IOException e) {
      // LWJGL looks for it then.
      return Optional.empty();
    }
  }
}
