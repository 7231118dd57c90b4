package org.pendant.gui.editor.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.language.signature.Catalogue;

/**
 * Decides when the text of one editor is analysed: after a pause in typing, or at once when
 * somebody waits for it. Results of a text that has changed since are dropped, and texts that have
 * changed before their turn came are not read. Only the dispatch thread calls it.
 */
public final class AnalysisSchedule {
  /** How long nobody may type before an analysis begins. */
  static final int PAUSE_MS = 150;

  private final Background background;
  private final Executor dispatch;
  private final Catalogue catalogue;
  private final String name;
  private final Supplier<String> text;
  private final Consumer<AnalysedText> shown;
  private final List<Consumer<AnalysedText>> waiting = new ArrayList<>();
  private Optional<AnalysedText> newest = Optional.empty();
  private volatile long version;
  private long analysedVersion = -1;
  private long startedVersion = -1;

  /**
   * A schedule for one text.
   *
   * @param name what messages call the text
   * @param text the text now, asked on the dispatch thread
   * @param shown takes every result that is still of the text, on the dispatch thread
   */
  public AnalysisSchedule(
      Background background,
      Executor dispatch,
      Catalogue catalogue,
      String name,
      Supplier<String> text,
      Consumer<AnalysedText> shown) {
    this.background = background;
    this.dispatch = dispatch;
    this.catalogue = catalogue;
    this.name = name;
    this.text = text;
    this.shown = shown;
  }

  /** Says that the text is another now. */
  public void changed() {
    long changed = version + 1;
    version = changed;
    waiting.clear();
    background.run(PAUSE_MS, () -> dispatch.execute(() -> startIfStill(changed)));
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
    startIfStill(version);
  }

  /** The same, but nothing is hurried for it: while somebody types it comes at the next pause. */
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
    startedVersion = version;
    String now = text.get();
    background.run(
        0,
        () -> {
          if (wanted != version) {
            return; // somebody types faster than texts are read
          }
          AnalysedText result = AnalysedText.of(name, now, catalogue);
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
}
