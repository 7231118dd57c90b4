package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

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
  static final HelpPage KEYS = new HelpPage("keys", text("keyboardShortcuts"));

  /** What this program is. */
  static final HelpPage ABOUT = new HelpPage("about", text("aboutPendant"));

  /** Where reading begins. */
  static final HelpPage FIRST = new HelpPage("docs/desktop.md", text("theWindow"));

  /** How tests are written. */
  static final HelpPage TESTS = new HelpPage("docs/testing.md", text("tests"));

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
        new HelpPage("docs/learn/first-program.md", text("yourFirstProgram")),
        new HelpPage("docs/learn/debug.md", text("debugIt")),
        new HelpPage("docs/learn/first-tree.md", text("yourFirstTree")),
        new HelpPage("docs/testing-tutorial.md", text("yourFirstTest")),
        new HelpPage("docs/learn/cell.md", text("yourFirstCell")),
        new HelpPage("docs/language.md", text("writingPrograms")),
        new HelpPage("docs/functions.md", text("functions")),
        new HelpPage("docs/debugging.md", text("debugging")),
        new HelpPage("docs/program-trees.md", text("programsOfNodes")),
        new HelpPage("docs/program-files.md", text("programFiles")),
        new HelpPage("docs/installations.md", text("installations")),
        new HelpPage("docs/motion.md", text("motion")),
        new HelpPage("docs/safety.md", text("safety")),
        new HelpPage("docs/simulated-arm.md", text("theSimulatedArm")),
        new HelpPage("docs/robots.md", text("robots")),
        new HelpPage("docs/recording.md", text("recordings")),
        TESTS,
        new HelpPage("docs/testing-functions.md", text("functionsOfTests")),
        new HelpPage("docs/scene.md", text("scenes")),
        new HelpPage("docs/devices.md", text("devicesOfTheCell")),
        new HelpPage("docs/conveyors.md", text("conveyors")),
        new HelpPage("docs/toolpaths.md", text("toolpaths")),
        new HelpPage("docs/outside.md", text("socketsAndXmlRpc")),
        new HelpPage("docs/external-control.md", text("externalControl")),
        new HelpPage("docs/protocols/README.md", text("ports")),
        new HelpPage("docs/command-line.md", text("commandLine")),
        new HelpPage("docs/faq.md", text("questions")),
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
