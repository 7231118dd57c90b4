package org.pendant.command.doctor;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Private names: what texts for others are written without. The home folder becomes {@code ~}, the
 * user {@code USER}, this computer {@code HOST}.
 */
final class PrivateNames {
  /** A shorter name would be found in words that mean something else. */
  private static final int MIN_LENGTH = 3;

  private final List<Replacement> replacements = new ArrayList<>();

  private record Replacement(Pattern name, String by) {}

  PrivateNames(String home, String user, String host) {
    if (home.length() > 1) {
      replacements.add(new Replacement(Pattern.compile(Pattern.quote(home)), "~"));
    }
    addWord(user, "USER");
    addWord(host, "HOST");
  }

  /**
   * Those of this computer.
   *
   * @param environment variables, by name
   */
  static PrivateNames of(Map<String, String> environment) {
    return new PrivateNames(
        System.getProperty("user.home"), System.getProperty("user.name"), host(environment));
  }

  private void addWord(String name, String by) {
    if (name.length() >= MIN_LENGTH) {
      Pattern word = Pattern.compile("(?<![A-Za-z0-9])" + Pattern.quote(name) + "(?![A-Za-z0-9])");
      replacements.add(new Replacement(word, by));
    }
  }

  private static String host(Map<String, String> environment) {
    String known =
        environment.getOrDefault("COMPUTERNAME", environment.getOrDefault("HOSTNAME", ""));
    try {
      return known.isEmpty() ? Files.readString(Path.of("/etc/hostname")).strip() : known;
    } catch (IOException e) {
      return "";
    }
  }

  /** A text without them. */
  String removedFrom(String text) {
    String result = text;
    for (Replacement each : replacements) {
      result = each.name().matcher(result).replaceAll(Matcher.quoteReplacement(each.by()));
    }
    return result;
  }
}
