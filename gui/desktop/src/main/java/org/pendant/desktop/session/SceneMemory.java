package org.pendant.desktop.session;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.kit.settings.Settings;

/**
 * Scene memory: which scene was around the arm with which installation. It is kept by the window
 * and not in installations: these go to real robots, which have surroundings of their own.
 */
public final class SceneMemory {
  static final String SETTING = "scene.files";

  /** More installations than anybody works with. */
  private static final int MAX_INSTALLATIONS = 100;

  private static final String NEVER_SAVED = "";

  private final Settings settings;
  private final Map<String, String> scenes = new LinkedHashMap<>();

  /** That of {@code settings}. */
  public SceneMemory(Settings settings) {
    this.settings = settings;
    settings
        .get(SETTING)
        .orElse("")
        .lines()
        .map(line -> line.split("\t", -1))
        .filter(words -> words.length == 2)
        .forEach(words -> scenes.put(words[0], words[1]));
  }

  /**
   * The scene that was there last.
   *
   * @param installation its file; empty for one that was never saved
   * @return empty if nothing is known; an empty path for no scene
   */
  public Optional<Path> of(Optional<Path> installation) {
    try {
      return Optional.ofNullable(scenes.get(name(installation))).map(Path::of);
    } catch (InvalidPathException e) {
      // Settings of another machine.
      return Optional.empty();
    }
  }

  /**
   * Remembers a scene.
   *
   * @param scene its file; empty for none
   */
  public void put(Optional<Path> installation, Optional<Path> scene) {
    String key = name(installation);
    scenes.remove(key);
    scenes.put(key, scene.map(SceneMemory::name).orElse(""));
    List<Map.Entry<String, String>> newest =
        List.copyOf(scenes.entrySet())
            .subList(Math.max(0, scenes.size() - MAX_INSTALLATIONS), scenes.size());
    settings.put(
        SETTING,
        newest.stream()
            .map(each -> each.getKey() + "\t" + each.getValue() + "\n")
            .collect(Collectors.joining()));
  }

  private static String name(Optional<Path> file) {
    return file.map(SceneMemory::name).orElse(NEVER_SAVED);
  }

  private static String name(Path file) {
    return file.toAbsolutePath().normalize().toString();
  }
}
