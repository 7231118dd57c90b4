package org.pendant.desktop.help;

import static org.pendant.desktop.help.HelpViewTexts.text;

import java.awt.Desktop;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import org.pendant.command.doctor.Doctor;
import org.pendant.command.doctor.ProblemReport;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.export.SaveDialog;
import org.pendant.kit.export.SaveRequest;

/** Help actions: documentation, keys, examples, what this program is and where its logs are. */
public final class HelpActions {
  private final ActionTable actions;
  private final JComponent under;
  private final Supplier<Map<String, List<String>>> groups;
  private final Path logs;
  private final Path settings;
  private final Consumer<String> tell;
  private final HelpPanel panel;

  /**
   * Help that is closed.
   *
   * @param under what it may cover
   * @param groups ids of the actions, by the titles under which the sheet of keys has them
   * @param logs where log files are
   * @param settings where settings are
   * @param tell tells something at the edge of the window
   */
  public HelpActions(
      ActionTable actions,
      JComponent under,
      Supplier<Map<String, List<String>>> groups,
      Path logs,
      Path settings,
      Consumer<String> tell) {
    this.actions = actions;
    this.under = under;
    this.groups = groups;
    this.logs = logs;
    this.settings = settings;
    this.tell = tell;
    panel = new HelpPanel(under, this::made, this::follow);
  }

  /**
   * Adds them.
   *
   * @param explain shows what is known about the name at the caret, or does what it is given
   * @param open opens a copy of an example
   * @param screen the id of the view in the main area
   */
  public void add(Consumer<Runnable> explain, Consumer<Example> open, Supplier<String> screen) {
    actions.add(
        Action.of(
            "help.documentation",
            text("helpAndDocumentation"),
            "",
            () -> panel.open(HelpPage.FIRST)));
    actions.add(
        Action.of(
            "help.context",
            text("helpOnTheNameAtThe"),
            "F1",
            () -> explain.accept(() -> panel.open(HelpPage.of(screen.get())))));
    actions.add(
        Action.of(
            "help.shortcuts", text("keyboardShortcuts"), "", () -> panel.open(HelpPage.KEYS)));
    actions.add(
        Action.of("help.tests", text("howToWriteTests"), "", () -> panel.open(HelpPage.TESTS)));
    for (Example each : Example.all()) {
      actions.add(Action.of(each.id(), each.title(), "", () -> open.accept(each)));
    }
    actions.add(
        Action.of("help.about", text("aboutPendant"), "", () -> panel.open(HelpPage.ABOUT)));
    actions.add(Action.of("help.logs", text("openTheFolderOfLogs"), "", () -> openFolder(logs)));
    actions.add(Action.of("help.report", text("reportAProblem"), "", this::report));
  }

  /** Closes the documentation, if it is open: something below it is to be seen. */
  public void close() {
    panel.close();
  }

  private String made(HelpPage page) {
    return page.equals(HelpPage.KEYS)
        ? ShortcutText.of(actions, groups.get())
        : page.equals(HelpPage.ABOUT) ? AboutText.of(logs, settings) : "";
  }

  private void follow(String link) {
    switch (link) {
      case "folder:logs" -> openFolder(logs);
      case "folder:settings" -> openFolder(settings);
      default -> OtherProgram.open(link, () -> Desktop.getDesktop().browse(URI.create(link)), tell);
    }
  }

  private void report() {
    SaveDialog.open(
        under,
        new SaveRequest(
            text("reportAProblemWithoutNamesAnd"),
            Path.of(System.getProperty("user.home"), "pendant-problem.zip"),
            List.of("zip"),
            List.of()),
        file -> AtomicFile.write(file, ProblemReport.of(Doctor.ofThisComputer().findings())::write),
        tell);
  }

  private void openFolder(Path folder) {
    OtherProgram.open(
        folder.toString(),
        () -> {
          Files.createDirectories(folder);
          Desktop.getDesktop().open(folder.toFile());
        },
        tell);
  }
}
