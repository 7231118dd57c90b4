package org.pendant.controller.message;

import static org.pendant.controller.message.MessageTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.message.Popup.Severity;

/** Open popups: those that are on the screen. Owned by the frame loop. */
public final class OpenPopups {
  /** More open windows than this help no operator: the oldest one that does not block goes. */
  private static final int MAX_OPEN = 64;

  /** Windows of a frame that hold up nothing; more are not shown. */
  static final int MAX_IN_FRAME = 16;

  /** Bytes of a text that are shown. */
  static final int MAX_TEXT = 4096;

  private static final int MAX_TITLE = 256;

  private final Operator operator;
  private final MessageLog log;
  private final PromptNumbers numbers;
  private List<Popup> open = List.of();
  private List<Popup> shown = new ArrayList<>();
  private int notShown;

  /**
   * An empty screen.
   *
   * @param log is told what had to go unread
   * @param numbers shared with the questions
   */
  public OpenPopups(Operator operator, MessageLog log, PromptNumbers numbers) {
    this.operator = operator;
    this.log = log;
    this.numbers = numbers;
  }

  /** Shows a popup, which may be answered already; {@link #isOpen} says whether it waits. */
  public Popup show(double timeS, String title, String text, Severity severity, boolean blocking) {
    Popup popup =
        new Popup(
            numbers.next(),
            timeS,
            LogEntry.shortened(title, MAX_TITLE),
            LogEntry.shortened(text, MAX_TEXT),
            severity,
            blocking);
    if (shown.size() >= MAX_IN_FRAME && !blocking) {
      notShown++;
      return popup;
    }
    shown.add(popup);
    switch (operator) {
      case Operator.Absent absent -> {}
      case Operator.Present present -> {
        List<Popup> more = new ArrayList<>(open);
        if (more.size() >= MAX_OPEN) {
          dropOldest(more);
        }
        more.add(popup);
        open = List.copyOf(more);
      }
    }
    return popup;
  }

  private void dropOldest(List<Popup> popups) {
    Optional<Popup> oldest = popups.stream().filter(each -> !each.blocking()).findFirst();
    oldest.ifPresent(
        popup -> {
          popups.remove(popup);
          log.warning(text("popupUnread", MAX_OPEN, popup.title(), popup.text()));
        });
  }

  /** Whether the popup still waits for an answer. */
  public boolean isOpen(Popup popup) {
    return open.contains(popup);
  }

  /** Whether a popup that blocks is open. */
  public boolean blocked() {
    return !open.isEmpty() && oneBlocks();
  }

  private boolean oneBlocks() {
    for (Popup popup : open) {
      if (popup.blocking()) {
        return true;
      }
    }
    return false;
  }

  /** Closes popup {@code number}; false when it is not open. */
  public boolean answer(long number) {
    List<Popup> rest = open.stream().filter(p -> p.number() != number).toList();
    boolean found = rest.size() < open.size();
    open = rest;
    return found;
  }

  /** Closes every popup that blocks: the program continues or ends without them. */
  public void closeBlocking() {
    open = open.stream().filter(p -> !p.blocking()).toList();
  }

  /** Closes all of them: a client has stopped the program that showed them. */
  public void closeAll() {
    open = List.of();
  }

  /** Those on the screen, oldest first. */
  public List<Popup> open() {
    return open;
  }

  /** What was shown since the last call, answered or not; for the frame's snapshot. */
  public List<Popup> takeNew() {
    if (notShown > 0) {
      log.warning(text("popupsNotShown", notShown));
      notShown = 0;
    }
    if (shown.isEmpty()) {
      return List.of();
    }
    List<Popup> taken = List.copyOf(shown);
    shown = new ArrayList<>();
    return taken;
  }
}
