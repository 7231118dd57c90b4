package org.pendant.testing.source;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Optional;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.installation.Installation;

/** Files that tests are in, and those that they name. */
@FunctionalInterface
public interface TestSources {
  /**
   * The content of a file.
   *
   * @param name as the command line gives it, or beside such a one
   * @throws IOException if it is not there or cannot be read; its message says why, for people
   */
  byte[] read(String name) throws IOException;

  /**
   * The folder from which a program may read files.
   *
   * @param name of the program's file
   */
  default ProgramsFolder folder(String name) {
    return ProgramsFolder.NONE;
  }

  /**
   * What a controller is switched on with for a program that brings a setup of its own.
   *
   * @param base what it is without
   * @param own the installation of the program
   * @param robot id of the arm that the program was made on, if its file tells
   * @throws IOException if the arm cannot be set up so; its message says why, for people
   */
  default ControllerOptions setUp(ControllerOptions base, Installation own, Optional<String> robot)
      throws IOException {
    return base.withInstallation(own);
  }

  /**
   * The name of a file that another one names.
   *
   * @param base the file that names it
   * @param name that counts from the folder of {@code base}
   */
  static String beside(String base, String name) {
    int slash = base.lastIndexOf('/');
    return name.startsWith("/") || slash < 0
        ? name
        : withoutDetours(base.substring(0, slash + 1) + name);
  }

  /** The same name without {@code x/..} in it, so that a file has one name however it is named. */
  private static String withoutDetours(String name) {
    Deque<String> parts = new ArrayDeque<>();
    for (int from = 0; from <= name.length(); ) {
      int to = name.indexOf('/', from);
      String part = name.substring(from, to < 0 ? name.length() : to);
      boolean back = part.equals("..") && !parts.isEmpty();
      if (back && !parts.getLast().equals("..") && !parts.getLast().isEmpty()) {
        parts.removeLast();
      } else if (!part.equals(".")) {
        parts.add(part);
      }
      from = to < 0 ? name.length() + 1 : to + 1;
    }
    return String.join("/", parts);
  }
}
