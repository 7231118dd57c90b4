import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Makes the packages for Linux from what Maven has built: an archive, and a Debian package where
 * there is {@code dpkg-deb}; docs/packages.md says what is in them. They are for the processor that
 * this runs on, or for that of the JDK whose modules are in the folder that the system property
 * {@code packages.jmods} names. Built twice by the same JDK, the same sources give the same
 * packages.
 */
final class LinuxPackages {
  private LinuxPackages() {}

  /**
   * Makes them.
   *
   * @param words the project's folder, the version, the time that files are from, who answers for
   *     the packages, as {@code NAME <ADDRESS>}, and the folder that they go to, which is emptied
   */
  public static void main(String[] words) throws IOException, InterruptedException {
    if (words.length != 5) {
      System.err.println(
          "expected the project's folder, a version, a time, a maintainer and a folder");
      System.exit(2);
    }
    Path project = Path.of(words[0]).toAbsolutePath().normalize();
    String version = words[1];
    Instant time = Instant.parse(words[2]);
    Path packages = Path.of(words[4]).toAbsolutePath().normalize();
    InstalledTree.delete(packages);
    Files.createDirectories(packages);

    Optional<Path> jmods =
        Optional.of(System.getProperty("packages.jmods", ""))
            .filter(each -> !each.isEmpty())
            .map(Path::of);
    PackageArchitecture processor =
        jmods.isPresent()
            ? PackageArchitecture.ofModules(jmods.get())
            : PackageArchitecture.ofThisMachine();
    String name = "pendant-" + version + "-linux-" + processor.name();
    Path tree = packages.resolve("tree").resolve(name);
    new InstalledTree(project, tree, processor, jmods, time).make();

    List<Path> made = new ArrayList<>();
    made.add(archive(tree, packages.resolve(name + ".tar.gz"), time));
    if (ExternalProgram.isThere("dpkg-deb")) {
      DebianPackage debian = new DebianPackage(project, tree, version, processor, time);
      made.add(debian.make(packages, words[3]));
    } else {
      System.err.println("packages: there is no dpkg-deb, hence no Debian package");
    }
    Path bill = project.resolve("gui/desktop/target/pendant.cdx.json");
    if (Files.exists(bill)) {
      Path copy = packages.resolve("pendant-" + version + ".cdx.json");
      made.add(Files.copy(bill, copy, StandardCopyOption.REPLACE_EXISTING));
    }
    Checksums.write(packages.resolve("SHA256SUMS"), made);
    for (Path each : made) {
      System.out.printf("packages: %s, %,d bytes%n", each, Files.size(each));
    }
  }

  /** The tree as one file, with names in order and the same times and owners everywhere. */
  private static Path archive(Path tree, Path archive, Instant time)
      throws IOException, InterruptedException {
    ExternalProgram.run(
        "tar",
        "--sort=name",
        "--mtime=@" + time.getEpochSecond(),
        "--owner=0",
        "--group=0",
        "--numeric-owner",
        "--use-compress-program=gzip -9n",
        "-cf",
        archive.toString(),
        "-C",
        tree.getParent().toString(),
        tree.getFileName().toString());
    return archive;
  }
}
