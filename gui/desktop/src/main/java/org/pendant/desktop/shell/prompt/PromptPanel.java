package org.pendant.desktop.shell.prompt;

import static org.pendant.desktop.shell.prompt.PromptTexts.text;

import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import javax.swing.text.JTextComponent;
import org.pendant.controller.command.Command;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.action.Action;
import org.pendant.kit.action.ActionTable;
import org.pendant.kit.action.KeyText;
import org.pendant.kit.theme.Overlay;

/**
 * Prompt panel: shows popups and questions of programs, one at a time, over the views and never
 * over the footer. It takes the focus unless the user types; the action {@value #ANSWER} gives it
 * the focus then.
 */
public final class PromptPanel {
  /** The action that brings the focus here. */
  static final String ANSWER = "program.answer";

  private final Prompts prompts = new Prompts();
  private final PromptForm form;
  private final Overlay overlay;
  private final ActionTable actions;
  private final Consumer<Command> send;
  private Optional<Prompt> shown = Optional.empty();
  private boolean ready;
  private boolean wantsFocus;

  /**
   * A panel without popups; adds its action.
   *
   * @param under what it may cover
   * @param send has the controller do something, and tells when it is refused
   */
  public PromptPanel(JComponent under, ActionTable actions, Consumer<Command> send) {
    this.actions = actions;
    this.send = send;
    form = new PromptForm(new Gestures());
    overlay = new Overlay("popup", under, form.component());
    overlay.onEscape(this::leave);
    actions.add(
        new Action(
            ANSWER,
            text("answerThePopupOrQuestion"),
            "F7",
            () -> prompts.shown().isPresent(),
            this::focus),
        () -> text("noPopupOrQuestionIsOpen"));
  }

  /** What people do with the form. */
  final class Gestures {
    private Gestures() {}

    void close() {
      give(prompts.close());
    }

    void answer(boolean yes) {
      give(prompts.answer(yes));
    }

    void enter(String text) {
      if (ready) {
        Prompts.Entry entry = prompts.enter(text);
        form.showError(entry.error());
        overlay.place();
        // How many rows the words need is known when they have been laid out.
        EventQueue.invokeLater(overlay::place);
        give(entry.command());
      }
    }

    void stop() {
      give(prompts.stop());
    }

    void next() {
      prompts.next(System.nanoTime());
      update();
    }
  }

  private void give(Optional<Command> command) {
    if (command.isPresent()) {
      form.focusText();
      send.accept(command.get());
    }
  }

  /** Escape: closes what is not waited for; what is waited for stays open, never answered by it. */
  private void leave() {
    if (shown.filter(each -> !each.waits()).isPresent()) {
      give(prompts.close());
    } else {
      overlay.returnFocus();
    }
  }

  /** Shows what is open in a snapshot. */
  public void refresh(ControllerState state) {
    prompts.take(state, System.nanoTime());
    update();
  }

  private void update() {
    if (!prompts.shown().equals(shown)) {
      shown = prompts.shown();
      change();
    }
    if (shown.isEmpty()) {
      return;
    }
    form.showPlace(prompts.place());
    if (!ready && prompts.ready(System.nanoTime())) {
      ready = true;
      form.setReady(true);
      if (wantsFocus && (overlay.focusWithin() || !typing())) {
        focus();
      }
    }
    form.showHint(hint());
  }

  private void change() {
    ready = false;
    if (shown.isEmpty()) {
      overlay.close();
      return;
    }
    boolean within = overlay.focusWithin();
    wantsFocus = within || !typing();
    form.setReady(false);
    form.show(shown.get());
    if (within) {
      form.focusText();
    }
    overlay.open();
    form.showPlace(prompts.place());
    form.showHint(hint());
    form.fit();
    overlay.place();
  }

  private void focus() {
    if (ready) {
      overlay.takeFocus(form.safeChoice());
    } else {
      wantsFocus = true;
      overlay.takeFocus(form.text());
    }
  }

  private String hint() {
    if (overlay.focusWithin()) {
      return shown.filter(Prompt::waits).isPresent()
          ? text("escLeavesThisOpenAndGoes")
          : text("escClosesIt");
    }
    String keys = KeyText.shown(actions.keysOf(ANSWER));
    return keys.isEmpty() ? text("aClickInHereBringsThe") : text("toAnswerByKey", keys);
  }

  /** Whether the user types: a key meant for the text must not answer a popup. */
  private static boolean typing() {
    return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner()
            instanceof JTextComponent field
        && field.isEditable();
  }
}
