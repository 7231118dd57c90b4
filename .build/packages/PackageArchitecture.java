/**
 * Architecture of the processors that packages are for.
 *
 * @param name as in the names of archives
 * @param debian as Debian calls it
 * @param natives what the names of jars with native code for it end with
 */
record PackageArchitecture(String name, String debian, String natives) {

  /** The one that this JVM runs on. */
  static PackageArchitecture ofThisMachine() {
    return switch (System.getProperty("os.arch")) {
      case "amd64" -> new PackageArchitecture("x64", "amd64", "natives-linux.jar");
      case "aarch64" -> new PackageArchitecture("arm64", "arm64", "natives-linux-arm64.jar");
      case String other -> throw new IllegalStateException("no packages are made for " + other);
    };
  }
}
