package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.pendant.kit.background.WorkQueue;
import org.pendant.language.signature.Catalogue;
import org.pendant.testing.builtin.TestCatalogue;

/**
 * Analysis schedule: decides when the text of one editor is analysed: after a pause in typing, or
 * immediately when the user waits for it. Results of a text that has changed since are dropped,
 * texts that have changed before their turn came are not read, and long texts are read less often:
 * reading takes time and memory from the user who types. Only the dispatch thread calls it.
 */
public final class AnalysisSchedule {
  /** How long typing must rest before an analysis begins. */
  static final int PAUSE_MS = 150;

  /** The same for a long text. */
  static final int LONG_PAUSE_MS = 1_000;

  /** A text with more characters is long: reading it takes a second and much memory. */
  private static final int LONG = 1_000_000;

  /** Between two analyses this many times as long passes as the last one took. */
  private static final int REST_SHARE = 4;

  /** However long one took, the next does not wait for more than two seconds. */
  private static final long MAX_COUNTED_NS = 500_000_000;

  private static final long NS_PER_MS = 1_000_000;

  private final WorkQueue background;
  private final Executor dispatch;
  private final Catalogue catalogue;
  private final String name;
  private final Supplier<String> text;
  private final Consumer<AnalysedText> shown;
  private final LongSupplier clockNs;
  private final List<Consumer<AnalysedText>> waiting = new ArrayList<>();
  private Optional<AnalysedText> newest = Optional.empty();
  private volatile long version;
  private volatile long restUntilNs;
  private long analysedVersion = -1;
  private long startedVersion = -1;

  /**
   * A schedule for one text.
   *
   * @param name what messages call the text
   * @param text the text now, asked on the dispatch thread
   * @param shown takes every result that is still of the text, on the dispatch thread
   * @param clockNs any clock that runs, ns
   */
  public AnalysisSchedule(
      WorkQueue background,
      Executor dispatch,
      Catalogue catalogue,
      String name,
      Supplier<String> text,
      Consumer<AnalysedText> shown,
      LongSupplier clockNs) {
    this.background = background;
    this.dispatch = dispatch;
    this.catalogue = catalogue;
    this.name = name;
    this.text = text;
    this.shown = shown;
    this.clockNs = clockNs;
    restUntilNs = clockNs.getAsLong();
  }

  /** Says that the text is another now. */
  public void changed() {
    long changed = version + 1;
    version = changed;
    waiting.clear();
    background.run(
        isLong() ? LONG_PAUSE_MS : PAUSE_MS, () -> dispatch.execute(() -> startIfStill(changed)));
  }

  /** Whether the text is so long that nothing should be looked up while the user types. */
  public boolean isLong() {
    return text.get().length() > LONG;
  }

  /** The newest result, if it is one of the text as it is. */
  public Optional<AnalysedText> current() {
    return analysedVersion == version ? newest : Optional.empty();
  }

  /**
   * Hands over a result of the text as it is as soon as there is one: at once if there is. If the
   * text changes before, nothing comes.
   */
  public void whenCurrent(Consumer<AnalysedText> receiver) {
    Optional<AnalysedText> current = current();
    if (current.isPresent()) {
      receiver.accept(current.get());
      return;
    }
    waiting.add(receiver);
    start();
  }

  /** The same for what was not asked for: long texts rest between two readings. */
  public void whenDue(Consumer<AnalysedText> receiver) {
    whenRested(receiver);
    startIfStill(version);
  }

  /** The same, but nothing is hurried for it: while the user types it comes at the next pause. */
  public void whenRested(Consumer<AnalysedText> receiver) {
    Optional<AnalysedText> current = current();
    if (current.isPresent()) {
      receiver.accept(current.get());
    } else {
      waiting.add(receiver);
    }
  }

  private void startIfStill(long wanted) {
    if (wanted != version || startedVersion == version || analysedVersion == version) {
      return;
    }
    long restMs = (restUntilNs - clockNs.getAsLong()) / NS_PER_MS;
    if (restMs > 0) {
      background.run((int) restMs, () -> dispatch.execute(() -> startIfStill(wanted)));
    } else {
      start();
    }
  }

  private void start() {
    if (startedVersion == version) {
      return;
    }
    long wanted = version;
    startedVersion = wanted;
    String now = text.get();
    background.run(
        0,
        () -> {
          if (wanted != version) {
            return; // the user types faster than texts are read
          }
          long begin = clockNs.getAsLong();
          AnalysedText result = AnalysedText.of(name, now, catalogue(name));
          long end = clockNs.getAsLong();
          restUntilNs = end + REST_SHARE * Math.min(end - begin, MAX_COUNTED_NS);
          dispatch.execute(() -> finished(wanted, result));
        });
  }

  private void finished(long analysed, AnalysedText result) {
    if (analysed != version) {
      return;
    }
    analysedVersion = analysed;
    newest = Optional.of(result);
    shown.accept(result);
    List<Consumer<AnalysedText>> receivers = List.copyOf(waiting);
    waiting.clear();
    receivers.forEach(receiver -> receiver.accept(result));
  }

  /** What may be called in a text of this name. */
  private Catalogue catalogue(String ofText) {
    return TestCatalogue.isFor(ofText) ? new TestCatalogue() : catalogue;
  }
}
