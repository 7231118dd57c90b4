package org.pendant.desktop.help;

import java.nio.file.Path;
import java.util.List;

/**
 * A page of the help.
 *
 * @param name where its text is: beside this class, or one of those that the window makes itself
 * @param title what the list of pages calls it
 */
record HelpPage(String name, String title) {
  /** The keys that do actions now. */
  static final HelpPage KEYS = new HelpPage("keys", "Keyboard shortcuts");

  /** What this program is. */
  static final HelpPage ABOUT = new HelpPage("about", "About Pendant");

  /** Where reading begins. */
  static final HelpPage FIRST = new HelpPage("docs/desktop.md", "The window");

  /** How tests are written. */
  static final HelpPage TESTS = new HelpPage("docs/testing.md", "Tests");

  /** The page about a screen, by the id of its view; the first one where there is none. */
  static HelpPage of(String screen) {
    String name =
        switch (screen) {
          case "program" -> "docs/program-trees.md";
          case "script" -> "docs/language.md";
          case "installation" -> "docs/installations.md";
          default -> FIRST.name();
        };
    return all().stream().filter(each -> each.name().equals(name)).findFirst().orElse(FIRST);
  }

  /** All pages of the list, in its order. */
  static List<HelpPage> all() {
    return List.of(
        FIRST,
        KEYS,
        new HelpPage("docs/learn/first-program.md", "Your first program"),
        new HelpPage("docs/learn/debug.md", "Debug it"),
        new HelpPage("docs/learn/first-tree.md", "Your first tree"),
        new HelpPage("docs/testing-tutorial.md", "Your first test"),
        new HelpPage("docs/learn/cell.md", "Your first cell"),
        new HelpPage("docs/language.md", "Writing programs"),
        new HelpPage("docs/functions.md", "Functions"),
        new HelpPage("docs/debugging.md", "Debugging"),
        new HelpPage("docs/program-trees.md", "Programs of nodes"),
        new HelpPage("docs/program-files.md", "Program files"),
        new HelpPage("docs/installations.md", "Installations"),
        new HelpPage("docs/motion.md", "Motion"),
        new HelpPage("docs/safety.md", "Safety"),
        new HelpPage("docs/simulated-arm.md", "The simulated arm"),
        new HelpPage("docs/robots.md", "Robots"),
        new HelpPage("docs/recording.md", "Recordings"),
        TESTS,
        new HelpPage("docs/testing-functions.md", "Functions of tests"),
        new HelpPage("docs/scene.md", "Scenes"),
        new HelpPage("docs/devices.md", "Devices of the cell"),
        new HelpPage("docs/conveyors.md", "Conveyors"),
        new HelpPage("docs/toolpaths.md", "Toolpaths"),
        new HelpPage("docs/outside.md", "Sockets and XML-RPC"),
        new HelpPage("docs/external-control.md", "External Control"),
        new HelpPage("docs/protocols/README.md", "Ports"),
        new HelpPage("docs/command-line.md", "Command line"),
        new HelpPage("docs/faq.md", "Questions"),
        ABOUT);
  }

  @Override
  public String toString() {
    return title;
  }

  /** The page that a link on this one leads to, without the place on it. */
  String target(String link) {
    String folder = name.substring(0, name.lastIndexOf('/') + 1);
    String path = link.replaceFirst("#.*", "");
    return path.isEmpty() ? name : Path.of(folder + path).normalize().toString().replace('\\', '/');
  }
}
