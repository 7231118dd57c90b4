package org.pendant.kit.action;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import javax.swing.KeyStroke;
import org.pendant.kit.settings.Settings;
import org.pendant.kit.text.Messages;

/**
 * Action table: the actions of one window. On macOS they are done with Cmd where they come with
 * control. Keys that people have chosen are settings named {@code key.} and the action's id; {@code
 * none} there takes the key away.
 */
public final class ActionTable implements Actions {
  private static final String NONE = "none";

  private final Settings settings;
  private final KeyStyle style;
  private final Map<String, Action> byId = new LinkedHashMap<>();
  private final Map<String, Supplier<String>> reasons = new HashMap<>();
  private final List<Runnable> listeners = new ArrayList<>();
  private List<String> screens = List.of();

  /** No actions yet. */
  public ActionTable(Settings settings) {
    this(settings, KeyStyle.of(System.getProperty("os.name", "")));
  }

  ActionTable(Settings settings, KeyStyle style) {
    this.settings = settings;
    this.style = style;
  }

  @Override
  public void add(Action action) {
    if (byId.putIfAbsent(action.id(), action) != null) {
      throw new IllegalArgumentException("there is an action " + action.id() + " already");
    }
    if (!action.keys().isEmpty() && KeyStroke.getKeyStroke(action.keys()) == null) {
      throw new IllegalArgumentException(
          "keys of " + action.id() + " are '" + action.keys() + "', expected such as control P");
    }
    tell();
  }

  /** Adds an action that can say why it cannot be done while it cannot. */
  public void add(Action action, Supplier<String> reason) {
    reasons.put(action.id(), reason);
    add(action);
  }

  @Override
  public List<Action> all() {
    return List.copyOf(byId.values());
  }

  /** The action of this id, if there is one. */
  public Optional<Action> find(String id) {
    return Optional.ofNullable(byId.get(id));
  }

  @Override
  public void run(String id) {
    Action action = byId.get(id);
    if (action != null && action.enabled().getAsBoolean()) {
      action.run().run();
    }
  }

  /** Why the action cannot be done now; empty if it can or if the reason is not known. */
  public String reason(String id) {
    Action action = byId.get(id);
    if (action == null || action.enabled().getAsBoolean()) {
      return "";
    }
    return Messages.shown(reasons.getOrDefault(id, () -> "").get());
  }

  @Override
  public String keysOf(String id) {
    Optional<String> chosen = settings.get(setting(id));
    if (chosen.filter(NONE::equals).isPresent()) {
      return "";
    }
    return chosen
        .filter(keys -> KeyStroke.getKeyStroke(keys) != null)
        .or(() -> find(id).map(Action::keys).map(style::keys))
        .orElse("");
  }

  /** The key stroke that does the action now. */
  public Optional<KeyStroke> strokeOf(String id) {
    return Optional.ofNullable(KeyStroke.getKeyStroke(keysOf(id)));
  }

  /** Whether people have chosen another key than the action came with. */
  public boolean rebound(String id) {
    return !Objects.equals(
        KeyStroke.getKeyStroke(keysOf(id)),
        find(id).map(action -> KeyStroke.getKeyStroke(style.keys(action.keys()))).orElse(null));
  }

  /**
   * Does an action by another key from now on.
   *
   * @param keys as {@link Action#keys}; empty for none
   * @throws IllegalArgumentException if these are no keys
   */
  public void rebind(String id, String keys) {
    if (!keys.isEmpty() && KeyStroke.getKeyStroke(keys) == null) {
      throw new IllegalArgumentException("keys are '" + keys + "', expected such as control P");
    }
    settings.put(setting(id), keys.isEmpty() ? NONE : keys);
    tell();
  }

  /** Does an action by the key that it came with again. */
  public void reset(String id) {
    // Blank, not the key itself: the setting may be read on another kind of computer.
    find(id).ifPresent(action -> settings.put(setting(id), ""));
    tell();
  }

  /**
   * Actions whose ids begin with one of these words are done on a screen of their own each: they
   * may have the same keys.
   */
  public void setScreens(List<String> begins) {
    screens = List.copyOf(begins);
  }

  private Optional<String> screen(String id) {
    return screens.stream().filter(each -> id.startsWith(each + ".")).findFirst();
  }

  private boolean meet(String one, String other) {
    return screen(one).isEmpty() || screen(other).isEmpty() || screen(one).equals(screen(other));
  }

  /** Other actions that are done by this key, where this one is. */
  public List<Action> conflicts(String id, String keys) {
    KeyStroke stroke = KeyStroke.getKeyStroke(keys);
    return byId.values().stream()
        .filter(each -> !each.id().equals(id) && meet(id, each.id()))
        .filter(each -> stroke != null && stroke.equals(strokeOf(each.id()).orElse(null)))
        .toList();
  }

  /** Tells {@code listener} when actions or keys change. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private void tell() {
    List.copyOf(listeners).forEach(Runnable::run);
  }

  private static String setting(String id) {
    return "key." + id;
  }
}
