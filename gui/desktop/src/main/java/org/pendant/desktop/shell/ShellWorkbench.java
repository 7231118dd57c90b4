package org.pendant.desktop.shell;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.workbench.View;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.dock.DockFrame;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;

/** Workbench of the shell: the window as its views see it. */
final class ShellWorkbench implements Workbench {
  private final RobotSession session;
  private final ActionTable actions;
  private final Settings settings;
  private final BiConsumer<String, BooleanSupplier> tell;
  private final UsedFolder usedFolder = new UsedFolder();
  private DockFrame docks;
  private final Typing typing;
  private Optional<Supplier<View>> sourceView = Optional.empty();
  private Supplier<List<Path>> openFiles = List::of;
  private Supplier<Optional<Path>> programFolder = Optional::empty;
  private SourcePlace source = (line, column) -> {};

  ShellWorkbench(
      RobotSession session,
      ActionTable actions,
      Settings settings,
      BiConsumer<String, BooleanSupplier> tell,
      Typing typing) {
    this.typing = typing;
    this.session = session;
    this.actions = actions;
    this.settings = settings;
    this.tell = tell;
  }

  /** The views have been made, with this workbench, and are there from now on. */
  void attach(DockFrame frame) {
    docks = frame;
  }

  @Override
  public RobotSession session() {
    return session;
  }

  @Override
  public ActionTable actions() {
    return actions;
  }

  @Override
  public Settings settings() {
    return settings;
  }

  @Override
  public void show(String viewId) {
    if (docks != null) {
      docks.show(viewId);
    }
  }

  /** Source is shown by {@code place}, in what is {@code view} then. */
  void showSourceIn(Supplier<View> view, SourcePlace place) {
    sourceView = Optional.of(view);
    source = place;
  }

  /**
   * Keys go there afterwards, except when this happens by itself, at a stop of the debugger, while
   * keys go somewhere else on purpose. The caret of a user who is writing stays as well.
   */
  @Override
  public void showSource(int line, int column) {
    if (docks == null || sourceView.isEmpty()) {
      return;
    }
    View view = sourceView.get().get();
    if (typing.within(view.component())) {
      return;
    }
    if (typing.elsewhere(view.component())) {
      docks.reveal(view.id());
    } else {
      docks.show(view.id());
    }
    source.show(line, column);
  }

  /** {@code files} says which files are open. */
  void openFilesAre(Supplier<List<Path>> files) {
    openFiles = files;
  }

  /** Where dialogs for files begin. */
  UsedFolder usedFolder() {
    return usedFolder;
  }

  /** {@code folder} says where the program is that people see, if it has a file. */
  void programFolderIs(Supplier<Optional<Path>> folder) {
    programFolder = folder;
  }

  @Override
  public Path exportFile(String name) {
    return programFolder.get().orElse(usedFolder.get()).resolve(name);
  }

  @Override
  public List<Path> openFiles() {
    return openFiles.get();
  }

  @Override
  public void notify(String text, BooleanSupplier holds) {
    tell.accept(Messages.shown(text), holds);
  }
}
