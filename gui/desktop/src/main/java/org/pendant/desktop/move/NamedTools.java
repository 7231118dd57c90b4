package org.pendant.desktop.move;

import static org.pendant.desktop.move.MoveTexts.text;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.kit.settings.Settings;
import org.pendant.models.pose.Pose;

/**
 * Named tools: tool centre points by name: those of the installation, and others kept from one
 * start to the next.
 */
final class NamedTools {
  /** Longest name, in characters. */
  static final int MAX_NAME = 40;

  private static final String KEY = "move.tcps";

  private final Settings settings;
  private Map<String, Pose> installed = Map.of();
  private final SortedMap<String, Pose> tools = new TreeMap<>(String.CASE_INSENSITIVE_ORDER);

  /** As they were left; what is none is skipped. */
  NamedTools(Settings settings) {
    this.settings = settings;
    settings.get(KEY).ifPresent(text -> text.lines().forEach(this::read));
  }

  private void read(String line) {
    int end = line.indexOf('\t');
    if (end > 0 && problem(line.substring(0, end)).isEmpty()) {
      SavedNumbers.read(line.substring(end + 1), Pose.SIZE)
          .ifPresent(numbers -> tools.put(line.substring(0, end), Pose.of(numbers)));
    }
  }

  /** Why a name cannot be kept, as a sentence; empty if it can. */
  static String problem(String name) {
    if (name.isBlank()) {
      return text("giveTheTcpANameTo");
    }
    if (name.length() > MAX_NAME) {
      return text("theNameHasCharactersAtMost", name.length(), MAX_NAME);
    }
    return name.chars().anyMatch(Character::isISOControl)
        ? text("theNameHasControlCharacters")
        : "";
  }

  /** Those of the installation; they come before others of the same name. */
  void install(Map<String, Pose> inFlange) {
    installed = Collections.unmodifiableMap(new LinkedHashMap<>(inFlange));
  }

  /** Names of all, those of the installation first. */
  List<String> names() {
    Set<String> names = new LinkedHashSet<>(installed.keySet());
    names.addAll(tools.keySet());
    return List.copyOf(names);
  }

  /** The pose in the flange of the one with this name. */
  Optional<Pose> find(String name) {
    return Optional.ofNullable(installed.get(name)).or(() -> Optional.ofNullable(tools.get(name)));
  }

  /** Keeps one, in place of another of the same name. */
  void keep(String name, Pose inFlange) {
    tools.remove(name);
    tools.put(name, inFlange);
    write();
  }

  void forget(String name) {
    tools.remove(name);
    write();
  }

  private void write() {
    List<String> lines = new ArrayList<>();
    tools.forEach((name, pose) -> lines.add(name + "\t" + SavedNumbers.text(pose.toArray())));
    settings.put(KEY, String.join("\n", lines));
  }
}
