import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.FileTime;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * What is installed below a prefix such as {@code /usr}: the command in {@code bin}, the Java
 * runtime and the jars in {@code lib/pendant}, and in {@code share} what desktops, shells and
 * people look for. It can be put anywhere as a whole.
 */
final class InstalledTree {
  /** Whatever the language of who makes packages is. */
  private static final String ENGLISH = "-Duser.language=en";

  private final Path project;
  private final Path tree;
  private final Path library;
  private final Path share;
  private final PackageArchitecture processor;
  private final Optional<Path> jmods;
  private final Instant time;

  /**
   * A tree that is not made yet.
   *
   * @param jmods modules of another JDK that the runtime is linked of, instead of this one
   */
  InstalledTree(
      Path project, Path tree, PackageArchitecture processor, Optional<Path> jmods, Instant time) {
    this.project = project;
    this.tree = tree;
    this.processor = processor;
    this.jmods = jmods;
    this.time = time;
    library = tree.resolve("lib/pendant");
    share = tree.resolve("share");
  }

  void make() throws IOException, InterruptedException {
    linkRuntime();
    copyJars();
    copyLaunchers();
    copyDocuments();
    generate();
    finish(tree, time);
  }

  private void linkRuntime() throws IOException, InterruptedException {
    Files.createDirectories(library);
    // What jdeps finds in the jars, and the charsets of other computers' files.
    String modules = Files.readString(project.resolve(".build/packages/modules")).strip();
    Path jlink = Path.of(System.getProperty("java.home"), "bin/jlink");
    if (!Files.isExecutable(jlink)) {
      throw new IOException("this Java has no jlink, which a JDK has: " + jlink);
    }
    // jlink keeps its plugins in a map by identity, hence runs those of one kind in an order that
    // changes: all of them get the same hash. Of a JDK without jmods it takes folders in the order
    // in which this process has looked at them first: resources get an order of their own.
    List<String> command =
        new ArrayList<>(
            List.of(
                jlink.toString(),
                "-J-XX:+UseSerialGC",
                "-J-XX:+UnlockExperimentalVMOptions",
                "-J-XX:hashCode=2",
                "--order-resources=**",
                "--add-modules",
                modules,
                "--no-man-pages",
                "--no-header-files",
                "--compress",
                "zip-6",
                "--output",
                library.resolve("runtime").toString()));
    if (jmods.isEmpty()) {
      command.add("--strip-debug");
    } else {
      // The objcopy by which jlink strips libraries knows the processor of this computer. Those of
      // JDKs are stripped, with what was in them in files beside them.
      command.addAll(
          List.of(
              "--module-path",
              jmods.get().toString(),
              "--strip-java-debug-attributes",
              "--exclude-files=**.debuginfo"));
    }
    ExternalProgram.run(command.toArray(String[]::new));
  }

  private void copyJars() throws IOException, InterruptedException {
    Path built = project.resolve("gui/desktop/target");
    Path app = library.resolve("app");
    Files.createDirectories(app.resolve("lib"));
    Files.copy(built.resolve("pendant.jar"), app.resolve("pendant.jar"));
    for (Path file : sorted(built.resolve("lib"))) {
      String name = file.getFileName().toString();
      if (name.endsWith(".jar") && isForThisProcessor(name)) {
        Files.copy(file, app.resolve("lib").resolve(name));
      }
    }
    String java = Path.of(System.getProperty("java.home"), "bin/java").toString();
    ExternalProgram.run(
        java,
        "-XX:+UseSerialGC",
        "-XX:TieredStopAtLevel=1",
        project.resolve(".build/StartableJars.java").toString(),
        app.toString());
  }

  private boolean isForThisProcessor(String jar) {
    return !jar.contains("-natives-") || jar.endsWith(processor.natives());
  }

  private void copyLaunchers() throws IOException {
    Path sources = project.resolve(".build/packages/bin");
    copy(sources.resolve("pendant"), tree.resolve("bin/pendant"));
    copy(sources.resolve("prepare"), library.resolve("prepare"));
    copy(project.resolve(".build/options.sh"), library.resolve("options.sh"));
    copy(project.resolve(".build/start.sh"), library.resolve("start.sh"));
    Files.createDirectory(library.resolve("caches"));
    // AOT caches in folders of users are those of one build.
    List<Path> jars = new ArrayList<>(sorted(library.resolve("app/lib")));
    jars.add(library.resolve("app/pendant.jar"));
    jars.add(library.resolve("runtime/release"));
    Files.writeString(library.resolve("build"), Checksums.of(jars).substring(0, 16) + "\n");
  }

  private void copyDocuments() throws IOException {
    for (Path file : sorted(project.resolve("examples"))) {
      Path target =
          share.resolve("pendant/examples").resolve(project.resolve("examples").relativize(file));
      copy(file, target);
    }
    Path documents = share.resolve("doc/pendant");
    copy(project.resolve("LICENSE"), documents.resolve("LICENSE"));
    copy(project.resolve("gui/desktop/target/lib/NOTICE"), documents.resolve("NOTICE"));
    copy(project.resolve("CHANGELOG.md"), documents.resolve("CHANGELOG.md"));
    Path linux = project.resolve(".build/packages/linux");
    copy(linux.resolve("pendant.desktop"), share.resolve("applications/pendant.desktop"));
    copy(linux.resolve("pendant.xml"), share.resolve("mime/packages/pendant.xml"));
    Path icons = share.resolve("icons/hicolor");
    copy(linux.resolve("pendant.svg"), icons.resolve("scalable/apps/pendant.svg"));
    IconPictures.draw(linux.resolve("pendant.svg"), icons);
  }

  /** What the commands and options are made into. */
  private void generate() throws IOException, InterruptedException {
    // The runtime itself, unless it is for another computer.
    Path home =
        jmods.isPresent() ? Path.of(System.getProperty("java.home")) : library.resolve("runtime");
    String java = home.resolve("bin/java").toString();
    String jar = library.resolve("app/pendant.jar").toString();
    Path manual = Files.createDirectories(share.resolve("man/man1"));
    ExternalProgram.run(
        java,
        ENGLISH,
        "-cp",
        jar,
        "org.pendant.command.ManualPages",
        manual.toString(),
        time.toString());
    for (Path page : sorted(manual)) {
      ExternalProgram.run("gzip", "-9n", page.toString());
    }
    complete(java, jar, "bash", "bash-completion/completions/pendant");
    complete(java, jar, "zsh", "zsh/vendor-completions/_pendant");
    complete(java, jar, "fish", "fish/vendor_completions.d/pendant.fish");
  }

  private void complete(String java, String jar, String shell, String file)
      throws IOException, InterruptedException {
    Path target = share.resolve(file);
    Files.createDirectories(target.getParent());
    ExternalProgram.writing(target, List.of(java, ENGLISH, "-jar", jar, "completion", shell));
  }

  private static List<Path> sorted(Path folder) throws IOException {
    try (Stream<Path> all = Files.walk(folder)) {
      return all.filter(Files::isRegularFile).sorted().toList();
    }
  }

  static void copy(Path from, Path to) throws IOException {
    Files.createDirectories(to.getParent());
    Files.copy(from, to, StandardCopyOption.COPY_ATTRIBUTES);
  }

  /** Gives all files the same time, and modes that do not depend on who has built them. */
  static void finish(Path root, Instant time) throws IOException {
    try (Stream<Path> all = Files.walk(root)) {
      for (Path file : all.sorted(Comparator.reverseOrder()).toList()) {
        if (!Files.isSymbolicLink(file)) {
          boolean executable = Files.isDirectory(file) || Files.isExecutable(file);
          String mode = executable ? "rwxr-xr-x" : "rw-r--r--";
          Files.setPosixFilePermissions(file, PosixFilePermissions.fromString(mode));
          Files.setLastModifiedTime(file, FileTime.from(time));
        }
      }
    }
  }

  /** Deletes a folder with all that is in it. */
  static void delete(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path file : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
