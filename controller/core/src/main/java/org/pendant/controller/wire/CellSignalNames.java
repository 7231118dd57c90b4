package org.pendant.controller.wire;

import static org.pendant.controller.wire.SignalNameTexts.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/** Signal names: what signals there are in a cell, and how files call them. */
public final class CellSignalNames {
  /** A name in front of signals: it stands before a point, and a space ends it in rules. */
  private static final Pattern OWNER = Pattern.compile("[A-Za-z_][A-Za-z0-9_-]*");

  private static final Pattern NAME = Pattern.compile("(?:([^.]+)\\.)?(\\w+)(?:\\[(\\d{1,5})\\])?");

  private final Map<String, List<SignalGroup>> owners = new LinkedHashMap<>();

  /** The signals of one owner, which need no name in front. */
  public CellSignalNames(List<SignalGroup> own) {
    owners.put("", List.copyOf(own));
  }

  /**
   * From now on an owner has signals.
   *
   * @throws IllegalArgumentException if its name cannot stand in front of signals
   */
  public void add(String owner, List<SignalGroup> groups) {
    if (!OWNER.matcher(owner).matches()) {
      throw new IllegalArgumentException(text("owner", Json.quoted(owner)));
    }
    owners.put(owner, List.copyOf(groups));
  }

  /** All groups by their owners, the controller's own by an empty one. */
  public Map<String, List<SignalGroup>> all() {
    return Map.copyOf(owners);
  }

  /**
   * The signal of that name.
   *
   * @throws IllegalArgumentException if there is none; the message says what it must be
   */
  public CellSignal signal(String name) {
    return signal(name, false);
  }

  private CellSignal signal(String name, boolean settable) {
    Matcher parts = NAME.matcher(name);
    if (!parts.matches()) {
      throw new IllegalArgumentException(such(settable));
    }
    String owner = parts.group(1) == null ? "" : parts.group(1);
    List<SignalGroup> groups = owners.get(owner);
    if (groups == null) {
      throw new IllegalArgumentException(such(settable));
    }
    Optional<SignalGroup> found = find(groups, parts.group(2));
    if (found.isEmpty()) {
      throw new IllegalArgumentException(
          parts.group(3) == null ? such(settable) : text("oneOf", spans(owner, groups)));
    }
    SignalGroup group = found.get();
    boolean single = group.count() == 1 && parts.group(3) == null;
    int index =
        single ? group.first() : parts.group(3) == null ? -1 : Integer.parseInt(parts.group(3));
    if (!group.holds(index)) {
      throw new IllegalArgumentException(text("mustBeThat", span(owner, group)));
    }
    return new CellSignal(owner, group.name(), index);
  }

  /** The group that a signal is in. */
  public SignalGroup group(CellSignal signal) {
    return find(owners.get(signal.owner()), signal.group()).orElseThrow();
  }

  private static Optional<SignalGroup> find(List<SignalGroup> groups, String name) {
    return groups.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /**
   * A digital signal that must be there.
   *
   * @param settable whether it is one that devices set, an input of the controller for example
   * @throws JsonException if it is none
   */
  public CellSignal digital(JsonFields fields, String key, boolean settable) throws JsonException {
    return digital(fields.text(key), key, settable);
  }

  /**
   * As the other.
   *
   * @param key what the text is called in messages
   */
  public CellSignal digital(Json.Text text, String key, boolean settable) throws JsonException {
    CellSignal signal = required(text, key, settable);
    SignalGroup group = group(signal);
    if (!group.digital()) {
      throw refusal(text, key, text("digital"));
    }
    if (settable && !group.settable()) {
      throw refusal(text, key, such(true));
    }
    return signal;
  }

  /**
   * A signal, or a number, that can be set.
   *
   * @throws JsonException if it is none
   */
  public CellSignal settable(JsonFields fields, String key) throws JsonException {
    Json.Text text = fields.text(key);
    CellSignal signal = required(text, key, true);
    if (!group(signal).settable()) {
      throw refusal(text, key, such(true));
    }
    return signal;
  }

  private CellSignal required(Json.Text text, String key, boolean settable) throws JsonException {
    try {
      return signal(text.value(), settable);
    } catch (IllegalArgumentException e) {
      throw refusal(text, key, e.getMessage());
    }
  }

  private static JsonException refusal(Json.Text text, String key, String expected) {
    return text.place().refusal(text("refused", key, text.described(), expected));
  }

  /** What a name must be, with an example of each owner. */
  private String such(boolean settable) {
    List<String> examples = new ArrayList<>();
    owners.forEach(
        (owner, groups) ->
            groups.stream()
                .filter(each -> each.settable() || !settable)
                .filter(each -> !owner.isEmpty() || each.settable() == settable)
                .findFirst()
                .map(each -> new CellSignal(owner, each.name(), each.first()).toString())
                .ifPresent(examples::add));
    return text(settable ? "input" : "signal", String.join(" or ", examples));
  }

  private static String spans(String owner, List<SignalGroup> groups) {
    return String.join(", ", groups.stream().map(each -> span(owner, each)).toList());
  }

  private static String span(String owner, SignalGroup group) {
    return new CellSignal(owner, group.name(), group.first())
        + (group.count() == 1 ? "" : " to [" + group.last() + "]");
  }
}
