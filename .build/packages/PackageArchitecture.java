import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.spi.ToolProvider;

/**
 * Architecture of the processors that packages are for.
 *
 * @param name as in the names of archives
 * @param debian as Debian calls it
 * @param natives what the names of jars with native code for it end with
 */
record PackageArchitecture(String name, String debian, String natives) {
  private static final Pattern PLATFORM = Pattern.compile("(?m)^platform linux-(\\S+)$");

  /** The one that this JVM runs on. */
  static PackageArchitecture ofThisMachine() {
    return of(System.getProperty("os.arch"));
  }

  /** The one that a JDK for Linux is for, whose modules, {@code NAME.jmod}, are in a folder. */
  static PackageArchitecture ofModules(Path jmods) throws IOException {
    StringWriter description = new StringWriter();
    PrintWriter output = new PrintWriter(description);
    String base = jmods.resolve("java.base.jmod").toString();
    int code = ToolProvider.findFirst("jmod").orElseThrow().run(output, output, "describe", base);
    Matcher platform = PLATFORM.matcher(description.toString());
    if (code != 0 || !platform.find()) {
      throw new IOException(base + " is not the java.base of a JDK for Linux: " + description);
    }
    return of(platform.group(1));
  }

  private static PackageArchitecture of(String processor) {
    return switch (processor) {
      case "amd64" -> new PackageArchitecture("x64", "amd64", "natives-linux.jar");
      case "aarch64" -> new PackageArchitecture("arm64", "arm64", "natives-linux-arm64.jar");
      case String other -> throw new IllegalStateException("no packages are made for " + other);
    };
  }
}
