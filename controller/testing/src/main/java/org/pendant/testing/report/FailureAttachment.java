package org.pendant.testing.report;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;

/**
 * Failure attachment: a file that belongs to a red test and lies in the folder of the report.
 *
 * @param file its name relative to that folder, with {@code /} between its parts
 * @param title what it shows, for people
 * @param kind how it is shown
 */
public record FailureAttachment(String file, String title, Kind kind) {
  /** How an attachment is shown. */
  public enum Kind {
    /** As a picture: {@code .png}, {@code .svg}. */
    IMAGE,
    /** As a link, such as to a recording. */
    LINK
  }

  /**
   * Refuses a name that leads out of the folder.
   *
   * @throws IllegalArgumentException if the name is empty, absolute or has {@code ..} in it
   */
  public FailureAttachment {
    if (file.isEmpty()
        || file.startsWith("/")
        || file.contains("\\")
        || Arrays.asList(file.split("/", -1)).contains("..")) {
      throw new IllegalArgumentException(
          "attachment is at " + file + ", expected a file in the folder of the report");
    }
  }

  /** The address of the file in the page: no character of a name can be read as something else. */
  String address() {
    StringBuilder address = new StringBuilder();
    for (byte each : file.getBytes(StandardCharsets.UTF_8)) {
      boolean plain =
          (each >= 'a' && each <= 'z')
              || (each >= 'A' && each <= 'Z')
              || (each >= '0' && each <= '9')
              || "-._~/".indexOf(each) >= 0;
      address.append(plain ? "" + (char) each : String.format(Locale.ROOT, "%%%02X", each & 0xff));
    }
    return address.toString();
  }
}
