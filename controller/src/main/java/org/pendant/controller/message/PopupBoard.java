package org.pendant.controller.message;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.message.Popup.Severity;

/** The popups that are on the screen, owned by the frame loop. */
public final class PopupBoard {
  /** More open windows than this help nobody: the oldest one that does not block goes. */
  private static final int MOST_OPEN = 64;

  private final Operator operator;
  private List<Popup> open = List.of();
  private List<Popup> shown = new ArrayList<>();
  private long newest;

  /** An empty screen. */
  public PopupBoard(Operator operator) {
    this.operator = operator;
  }

  /** Who answers. */
  public Operator operator() {
    return operator;
  }

  /** Shows a popup; it may be answered already, see {@link #isOpen}. */
  public Popup show(double timeS, String title, String text, Severity severity, boolean blocking) {
    newest++;
    Popup popup = new Popup(newest, timeS, title, text, severity, blocking);
    shown.add(popup);
    if (!operator.continuesAtOnce(popup)) {
      List<Popup> more = new ArrayList<>(open);
      if (more.size() >= MOST_OPEN) {
        more.remove(more.stream().filter(p -> !p.blocking()).findFirst().orElse(more.getFirst()));
      }
      more.add(popup);
      open = List.copyOf(more);
    }
    return popup;
  }

  /** Whether the popup still waits for an answer. */
  public boolean isOpen(Popup popup) {
    return open.contains(popup);
  }

  /** Whether a popup that blocks is open. */
  public boolean blocked() {
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

  /** Closes every popup that blocks: the program goes on or ends without them. */
  public void closeBlocking() {
    open = open.stream().filter(p -> !p.blocking()).toList();
  }

  /** Those on the screen, oldest first. */
  public List<Popup> open() {
    return open;
  }

  /** What was shown since the last call, answered or not; for the frame's snapshot. */
  public List<Popup> takeNew() {
    if (shown.isEmpty()) {
      return List.of();
    }
    List<Popup> taken = List.copyOf(shown);
    shown = new ArrayList<>();
    return taken;
  }
}
