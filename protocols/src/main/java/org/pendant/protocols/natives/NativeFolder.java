package org.pendant.protocols.natives;

import static org.pendant.protocols.natives.NativesTexts.text;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.nio.file.attribute.UserPrincipal;
import java.util.Comparator;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * Native library folder: finds a folder that only this user can write, for the native parts of
 * libraries. What lies in it is loaded as code of this process, so it must never be one that others
 * can make or fill first.
 */
public final class NativeFolder {
  private static final String NAME = "pendant-native";
  private static final int MODE = 0777;
  private static final int OF_THE_USER_ALONE = 0700;
  private static final int WRITABLE_BY_OTHERS = 0022;

  /** In such a folder only the owner of a file can remove or rename it. */
  private static final int STICKY = 01000;

  private NativeFolder() {}

  /**
   * The folder of this user, in the folder for caches ({@code XDG_CACHE_HOME} or {@code ~/.cache}).
   * Where that cannot be trusted or written: one for this process only, which goes with it.
   *
   * @throws IOException when there is no place that others cannot write
   */
  public static Path ofUser() throws IOException {
    return of(cache(System.getenv("XDG_CACHE_HOME"), System.getProperty("user.home")));
  }

  static Path of(Optional<Path> cache) throws IOException {
    if (cache.isPresent()) {
      try {
        return in(cache.get());
      } catch (IOException e) {
        // No home, a full disk or a folder of another user: the temporary one serves as well.
      }
    }
    Path folder = Files.createTempDirectory(NAME);
    Runtime.getRuntime().addShutdownHook(Thread.ofPlatform().unstarted(() -> remove(folder)));
    requireOwn(folder.toRealPath());
    return folder.toRealPath();
  }

  private static Optional<Path> cache(String given, String home) {
    try {
      // By the XDG specification a path that is not absolute is passed over.
      return Stream.of(
              Optional.ofNullable(given), Optional.ofNullable(home).map(h -> h + "/.cache"))
          .flatMap(Optional::stream)
          .map(Path::of)
          .filter(Path::isAbsolute)
          .findFirst();
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  /**
   * The folder below {@code cache}, made when it is not there.
   *
   * @throws IOException if it cannot be made, is a link, belongs to another user, or others can
   *     write there or exchange it
   */
  static Path in(Path cache) throws IOException {
    Files.createDirectories(cache);
    Path folder = cache.toRealPath().resolve(NAME);
    try {
      if (posix(cache)) {
        Files.createDirectory(
            folder,
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rwx------")));
      } else {
        Files.createDirectory(folder);
      }
    } catch (FileAlreadyExistsException e) {
      // Looked at below, whatever made it.
    }
    requireOwn(folder);
    return folder;
  }

  private static boolean posix(Path path) {
    return path.getFileSystem().supportedFileAttributeViews().contains("unix");
  }

  private static void requireOwn(Path folder) throws IOException {
    if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException(text("linkOrFile", folder));
    }
    if (!posix(folder)) {
      return; // a user's folders are closed to others there
    }
    if ((mode(folder) & MODE) != OF_THE_USER_ALONE) {
      throw new IOException(text("openToOthers", folder));
    }
    UserPrincipal self = self(folder);
    if (!owner(folder).equals(self)) {
      throw new IOException(text("belongsTo", folder, owner(folder).getName()));
    }
    for (Path above = folder.getParent(); above != null; above = above.getParent()) {
      int mode = mode(above);
      boolean superuser = Integer.valueOf(0).equals(Files.getAttribute(above, "unix:uid"));
      if (((mode & WRITABLE_BY_OTHERS) != 0 && (mode & STICKY) == 0)
          || (!superuser && !owner(above).equals(self))) {
        throw new IOException(text("aboveCanBeChangedByOthers", above, folder));
      }
    }
  }

  /** Who owns what this process makes. */
  private static UserPrincipal self(Path folder) throws IOException {
    Path probe = Files.createTempFile(folder, "owner", "");
    try {
      return owner(probe);
    } finally {
      Files.delete(probe);
    }
  }

  private static UserPrincipal owner(Path path) throws IOException {
    return Files.getOwner(path, LinkOption.NOFOLLOW_LINKS);
  }

  private static int mode(Path path) throws IOException {
    return (int) Files.getAttribute(path, "unix:mode", LinkOption.NOFOLLOW_LINKS);
  }

  private static void remove(Path folder) {
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path each : all.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(each);
      }
    } catch (IOException e) {
      // It lies among temporary files, which are swept anyway.
    }
  }
}
