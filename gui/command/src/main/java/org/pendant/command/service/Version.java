package org.pendant.command.service;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.Properties;

/** Version: which Pendant this is. */
public final class Version {
  /** Written by the build where there is a repository; see the pom. */
  private static final String COMMIT_FILE = "commit.properties";

  private Version() {}

  /** Its number, which the jar's manifest knows; classes that were just compiled have none. */
  public static String number() {
    return Optional.ofNullable(Version.class.getPackage().getImplementationVersion())
        .orElse("(development build)");
  }

  /**
   * The commit that it was built from and the day of that, such as {@code 30dd574f of 2026-11-28};
   * empty for what was built without the repository.
   */
  public static Optional<String> commit() {
    try (InputStream file = Version.class.getResourceAsStream(COMMIT_FILE)) {
      return file == null ? Optional.empty() : commit(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Optional<String> commit(InputStream file) throws IOException {
    Properties properties = new Properties();
    properties.load(file);
    String hash = properties.getProperty("git.commit.id.abbrev", "");
    String day = properties.getProperty("git.commit.time", "");
    return hash.isEmpty() ? Optional.empty() : Optional.of(hash + " of " + day);
  }

  /** The line that {@code pendant --version} prints. */
  public static String line() {
    return "pendant "
        + number()
        + commit().map(commit -> " (commit " + commit + ")").orElse("")
        + ", URScript as of PolyScope 5.24.1";
  }
}
