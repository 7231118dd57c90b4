package org.pendant.desktop.preview;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

/** A workbench around some views, for tests and previews; it remembers what it was told. */
public class PreviewWorkbench implements Workbench {
  private final Optional<RobotSession> session;
  private final Settings settings = new MemorySettings();
  private final ActionTable actions = new ActionTable(settings);
  private final List<String> told = new ArrayList<>();

  /** A workbench that forgets everything with its end. */
  public PreviewWorkbench(RobotSession session) {
    this.session = Optional.of(session);
  }

  /** One without a session, for tests that drive a controller themselves. */
  public PreviewWorkbench() {
    session = Optional.empty();
  }

  @Override
  public RobotSession session() {
    return session.orElseThrow(() -> new UnsupportedOperationException("there is no session"));
  }

  @Override
  public ActionTable actions() {
    return actions;
  }

  /** Does an action, as a key or the palette would. */
  public void run(String action) {
    actions.run(action);
  }

  @Override
  public Settings settings() {
    return settings;
  }

  @Override
  public void show(String viewId) {
    told.add("show " + viewId);
  }

  @Override
  public void showSource(int line, int column) {
    told.add("source " + line + ":" + column);
  }

  @Override
  public List<Path> openFiles() {
    return List.of();
  }

  @Override
  public Path exportFile(String name) {
    return Path.of(name);
  }

  @Override
  public void notify(String text, BooleanSupplier holds) {
    told.add(text);
  }

  /** What views have told and asked of the window, oldest first. */
  public List<String> told() {
    return List.copyOf(told);
  }
}
