package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

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
        Version.commit()
            .map(commit -> text("versionAndCommit", Version.number(), commit))
            .orElseGet(() -> text("version", Version.number())),
        text(
            "javaOn",
            Runtime.version(),
            System.getProperty("os.name"),
            System.getProperty("os.version"),
            System.getProperty("os.arch")),
        "",
        text("logsReportsAndInternalErrorsFolder", logs),
        text("settingsFolderSettings", settings),
        "",
        text("robotsOfUniversalRobotsAreSimulated"),
        "",
        "## " + text("libraries"),
        "",
        "```",
        HelpTexts.find("/NOTICE").orElse(text("aPackagedProgramListsItsLibraries")),
        "```",
        "",
        "## " + text("licence"),
        "",
        "```",
        HelpTexts.read("LICENSE"),
        "```");
  }
}
