package org.pendant.gui.preview;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.gui.session.Session;
import org.pendant.gui.workbench.Action;
import org.pendant.gui.workbench.Actions;
import org.pendant.gui.workbench.Settings;
import org.pendant.gui.workbench.Workbench;

/** A workbench around one view; it remembers what it was told. */
public final class PreviewWorkbench implements Workbench {
  private final Session session;
  private final List<Action> added = new ArrayList<>();
  private final Map<String, String> remembered = new HashMap<>();
  private final List<String> told = new ArrayList<>();

  /** A workbench that forgets everything with its end. */
  public PreviewWorkbench(Session session) {
    this.session = session;
  }

  @Override
  public Session session() {
    return session;
  }

  @Override
  public Actions actions() {
    return new Actions() {
      @Override
      public void add(Action action) {
        added.add(action);
      }

      @Override
      public List<Action> all() {
        return List.copyOf(added);
      }

      @Override
      public void run(String id) {
        added.stream().filter(each -> each.id().equals(id)).forEach(each -> each.run().run());
      }

      @Override
      public String keysOf(String id) {
        return "";
      }
    };
  }

  @Override
  public Settings settings() {
    return new Settings() {
      @Override
      public Optional<String> get(String name) {
        return Optional.ofNullable(remembered.get(name));
      }

      @Override
      public void put(String name, String text) {
        remembered.put(name, text);
      }
    };
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
  public void notify(String text) {
    told.add(text);
  }

  /** What views have told and asked of the window, oldest first. */
  public List<String> told() {
    return List.copyOf(told);
  }
}
