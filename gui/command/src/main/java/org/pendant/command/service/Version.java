package org.pendant.command.service;

import java.util.Optional;

/** Version: which Pendant this is. */
public final class Version {
  private Version() {}

  /** Its number, which the jar's manifest knows; classes that were just compiled have none. */
  public static String number() {
    return Optional.ofNullable(Version.class.getPackage().getImplementationVersion())
        .orElse("(development build)");
  }

  /** The line that {@code pendant --version} prints. */
  public static String line() {
    return "pendant " + number() + ", URScript as of PolyScope 5.24.1";
  }
}
