import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/**
 * A Debian package of the installed tree below {@code /usr}, by {@code dpkg-deb}. jpackage would
 * put it into {@code /opt} behind launchers that know one set of options for the JVM, while the
 * command here chooses them and an AOT cache by what it is asked for.
 */
final class DebianPackage {
  private final Path sources;
  private final Path tree;
  private final String version;
  private final PackageArchitecture processor;
  private final Instant time;

  DebianPackage(
      Path project, Path tree, String version, PackageArchitecture processor, Instant time) {
    this.tree = tree;
    // A snapshot comes before the version that it leads to.
    this.version = version.replace("-SNAPSHOT", "~snapshot");
    this.processor = processor;
    this.time = time;
    sources = project.resolve(".build/packages/debian");
  }

  /** Makes it in {@code folder}; {@code maintainer} answers for it. */
  Path make(Path folder, String maintainer) throws IOException, InterruptedException {
    Path root = tree.resolveSibling("debian");
    Path usr = root.resolve("usr");
    copyTree(tree, usr);
    // What is recorded on the computer itself is no part of /usr.
    Files.delete(usr.resolve("lib/pendant/caches"));
    Files.createSymbolicLink(usr.resolve("lib/pendant/caches"), Path.of("/var/cache/pendant"));
    Files.createDirectories(root.resolve("var/cache/pendant"));
    copyright(usr.resolve("share/doc/pendant"));

    Path control = root.resolve("DEBIAN");
    InstalledTree.copy(sources.resolve("postinst"), control.resolve("postinst"));
    InstalledTree.copy(sources.resolve("prerm"), control.resolve("prerm"));
    String template = Files.readString(sources.resolve("control"));
    Files.writeString(
        control.resolve("control"),
        template
            .replace("${version}", version)
            .replace("${maintainer}", maintainer)
            .replace("${architecture}", processor.debian())
            .replace("${installed.kb}", Long.toString(kilobytes(usr))));
    InstalledTree.finish(root, time);

    Path made = folder.resolve("pendant_" + version + "_" + processor.debian() + ".deb");
    ExternalProgram.run(
        Map.of("SOURCE_DATE_EPOCH", Long.toString(time.getEpochSecond())),
        ProcessBuilder.Redirect.DISCARD,
        "dpkg-deb",
        "--root-owner-group",
        "-Zxz",
        "--build",
        root.toString(),
        made.toString());
    return made;
  }

  /** Of Pendant and of each library, as Debian wants it in one file. */
  private void copyright(Path documents) throws IOException {
    Files.delete(documents.resolve("LICENSE"));
    String notice = Files.readString(documents.resolve("NOTICE"));
    String licence = "The Apache License is in /usr/share/common-licenses/Apache-2.0.\n\n";
    String runtime =
        "The Java runtime in /usr/lib/pendant/runtime is an OpenJDK, under the GNU General Public\n"
            + "License, version 2, with the Classpath Exception; its notices are in\n"
            + "/usr/lib/pendant/runtime/legal.\n\n";
    Files.writeString(documents.resolve("copyright"), licence + runtime + notice);
    Files.delete(documents.resolve("NOTICE"));
  }

  private static void copyTree(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    try (Stream<Path> all = Files.walk(from)) {
      for (Path file : all.sorted().toList()) {
        Files.copy(
            file,
            to.resolve(from.relativize(file)),
            StandardCopyOption.COPY_ATTRIBUTES,
            LinkOption.NOFOLLOW_LINKS);
      }
    }
  }

  private static long kilobytes(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      List<Path> files = all.filter(Files::isRegularFile).toList();
      long kilobytes = 0;
      for (Path file : files) {
        kilobytes += (Files.size(file) + 1023) / 1024;
      }
      return kilobytes;
    }
  }
}
