package org.pendant.desktop.help;

import java.nio.file.Path;
import org.pendant.command.service.Version;

/** What this program is, as a page of the help. */
final class AboutText {
  private AboutText() {}

  /**
   * The page.
   *
   * @param logs where log files are
   * @param settings where settings are
   */
  static String of(Path logs, Path settings) {
    return String.join(
        "\n",
        "# Pendant",
        "",
        "Version "
            + Version.number()
            + Version.commit().map(commit -> " (commit " + commit + ")").orElse("")
            + ", URScript as of PolyScope 5.24.1.",
        "Java "
            + Runtime.version()
            + " on "
            + System.getProperty("os.name")
            + " "
            + System.getProperty("os.version")
            + ", "
            + System.getProperty("os.arch")
            + ".",
        "",
        "- Logs, reports and internal errors: [`" + logs + "`](folder:logs)",
        "- Settings: [`" + settings + "`](folder:settings)",
        "",
        "Robots of Universal Robots are simulated from published numbers and recordings. Pendant is"
            + " not made by Universal Robots, and nothing here replaces a risk assessment.",
        "",
        "## Libraries",
        "",
        "```",
        HelpTexts.find("/NOTICE")
            .orElse("A packaged program lists its libraries and their licences here."),
        "```",
        "",
        "## Licence",
        "",
        "```",
        HelpTexts.read("LICENSE"),
        "```");
  }
}
