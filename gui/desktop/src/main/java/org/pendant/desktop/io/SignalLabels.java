package org.pendant.desktop.io;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import java.util.function.UnaryOperator;
import org.pendant.controller.io.Signal;
import org.pendant.kit.settings.Settings;

/**
 * Signal labels: the names that people give to signals and registers. Those of the installation
 * come first; those of the settings, where they were kept before there were installations, are only
 * read.
 */
public final class SignalLabels {
  private final UnaryOperator<String> read;
  private final BiConsumer<String, String> write;
  private final List<Runnable> listeners = new ArrayList<>();

  /** The names in {@code settings} alone. */
  public SignalLabels(Settings settings) {
    this(id -> settings.get(key(id)).orElse(""), (id, label) -> settings.put(key(id), label));
  }

  private SignalLabels(UnaryOperator<String> read, BiConsumer<String, String> write) {
    this.read = read;
    this.write = write;
  }

  /**
   * The names of an installation.
   *
   * @param settings names from before; one is forgotten as soon as its signal is named anew
   * @param named the name of a signal such as {@code digital_in[0]}; empty while it has none
   * @param rename takes such a signal and its new name, empty for none
   */
  public static SignalLabels installed(
      Settings settings, UnaryOperator<String> named, BiConsumer<String, String> rename) {
    return new SignalLabels(
        id -> {
          String name = named.apply(signalOf(id));
          return name.isEmpty() ? settings.get(key(id)).orElse("") : name;
        },
        (id, label) -> {
          settings.put(key(id), "");
          rename.accept(signalOf(id), label);
        });
  }

  /**
   * The signal of an id: {@code digital_in[0]} for {@code digital-in-0}; the id for what has no
   * number.
   */
  static String signalOf(String id) {
    int end = id.lastIndexOf('-');
    return end < 0
        ? id
        : id.substring(0, end).replace('-', '_') + "[" + id.substring(end + 1) + "]";
  }

  /** The name of a digital signal; empty while it has none. */
  public String of(Signal signal) {
    return of(SignalName.id(signal));
  }

  /**
   * The name of a signal or register; empty while it has none.
   *
   * @param id such as {@code digital-in-0}, {@code analog-in-1}, {@code input-float-register-3}
   */
  public String of(String id) {
    return read.apply(id);
  }

  /** The name of a signal such as {@code digital_in[0]}; empty while it has none. */
  public String ofSignal(String signal) {
    return of(signal.replace('_', '-').replace('[', '-').replace("]", ""));
  }

  /** Names a signal; spaces around the name do not count. */
  void name(String id, String label) {
    if (!label.strip().equals(of(id))) {
      write.accept(id, label.strip());
    }
  }

  /** Names have changed elsewhere. */
  public void changed() {
    listeners.forEach(Runnable::run);
  }

  /** Tells {@code listener} of names that have changed elsewhere. */
  void addListener(Runnable listener) {
    listeners.add(listener);
  }

  private static String key(String id) {
    return "io.label." + id;
  }
}
