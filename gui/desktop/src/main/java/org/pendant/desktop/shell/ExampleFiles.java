package org.pendant.desktop.shell;

import java.awt.Component;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.desktop.help.Example;
import org.pendant.desktop.shell.Notices.Choice;
import org.pendant.kit.background.Background;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;
import org.pendant.project.installation.text.InstallationText;

/**
 * Example files: opens copies of the programs that come with Pendant, and of what belongs to them.
 */
final class ExampleFiles {
  private final ProgramFiles files;
  private final InstallationFiles installations;
  private final Notices notices;
  private final Component parent;
  private final Consumer<String> tell;

  ExampleFiles(
      ProgramFiles files,
      InstallationFiles installations,
      Notices notices,
      Component parent,
      Consumer<String> tell) {
    this.files = files;
    this.installations = installations;
    this.notices = notices;
    this.parent = parent;
    this.tell = tell;
  }

  /** Opens a copy that has no file yet, so that nothing is overwritten. */
  void open(Example example) {
    Background.run(
        example::text,
        text -> {
          files.openCopy(example.file(), text);
          tell.accept("Opened a copy of the example " + example.file());
          example.companions().forEach(each -> offer(example, each));
        },
        failed -> tell.accept("Not opened: " + failed.getMessage()));
  }

  private void offer(Example example, String companion) {
    boolean installation = companion.endsWith(InstallationText.ENDING);
    notices.ask(
        "example-" + companion,
        example.file()
            + (installation
                ? " is made for the installation " + companion + "."
                : " needs " + companion + " in its folder."),
        List.of(
            installation
                ? new Choice("Use it", () -> take(companion))
                : new Choice("Save a copy\u2026", () -> save(companion)),
            Choice.nothing("Close")));
  }

  private void take(String companion) {
    Background.run(
        () -> Example.companion(companion),
        text -> installations.openCopy(companion, text),
        failed -> tell.accept("Not opened: " + failed.getMessage()));
  }

  private void save(String companion) {
    String ending = companion.substring(companion.lastIndexOf('.') + 1);
    SaveDialog.open(
        parent,
        new SaveRequest(
            "Save " + companion,
            Path.of(System.getProperty("user.home")).resolve(companion),
            List.of(ending),
            List.of()),
        file ->
            AtomicFile.write(file, Example.companion(companion).getBytes(StandardCharsets.UTF_8)),
        tell);
  }
}
