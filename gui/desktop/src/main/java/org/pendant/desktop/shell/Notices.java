package org.pendant.desktop.shell;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.BoxLayout;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.WrappingRow;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Card;
import org.pendant.kit.theme.Palette;
import org.pendant.kit.theme.WrappedText;

/** Questions above the views that can wait: the window is used meanwhile. */
@SuppressWarnings("serial") // never written to a stream
final class Notices extends JPanel {
  /** Name of the notice that shows what is cut off elsewhere. */
  static final String WHOLE = "whole-notice";

  private final Map<String, Notice> open = new LinkedHashMap<>();
  private final FocusListener focusKeeper =
      new FocusAdapter() {
        @Override
        public void focusGained(FocusEvent event) {
          Component before = event.getOppositeComponent();
          if (before == null || !SwingUtilities.isDescendingFrom(before, Notices.this)) {
            focusBefore = before;
          }
        }
      };

  /** Where keys went before they came to a question, by a click, too. */
  private Component focusBefore;

  /**
   * Something to choose; every choice closes the notice.
   *
   * @param word with which the name of its button ends
   * @param text of its button
   * @param harmless whether Escape may choose it
   */
  record Choice(String word, String text, Runnable run, boolean harmless) {
    Choice(String word, String text, Runnable run) {
      this(word, text, run, false);
    }

    /** Leaves everything as it is. */
    static Choice nothing(String word, String text) {
      return new Choice(word, text, () -> {}, true);
    }
  }

  Notices() {
    super(null);
    setLayout(new BoxLayout(this, BoxLayout.Y_AXIS));
    setName("notices");
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            // Texts break their lines elsewhere in another width.
            revalidate();
          }
        });
  }

  /** Space around each question. */
  private static int margin() {
    return UIScale.scale(8);
  }

  /** Tells something that must not pass unseen. */
  void tell(String name, String text) {
    ask(name, text, List.of(Choice.nothing("close", ShellTexts.text("close"))));
  }

  /**
   * Asks, in place of an earlier question of the same name.
   *
   * @param name of the component
   */
  void ask(String name, String text, List<Choice> choices) {
    close(name);
    Notice notice = new Notice(name, Messages.shown(text), choices);
    open.put(name, notice);
    JPanel framed = new JPanel(new BorderLayout());
    framed.setBorder(
        BorderFactory.createEmptyBorder(margin() / 2, margin(), margin() / 2, margin()));
    framed.add(notice);
    add(framed);
    revalidate();
  }

  /** Takes a question back. */
  void close(String name) {
    Notice notice = open.remove(name);
    if (notice != null) {
      if (focusBefore != null && focusBefore.isShowing() && within(notice)) {
        focusBefore.requestFocusInWindow();
      }
      remove(notice.getParent());
      revalidate();
      repaint();
    }
  }

  /** Whether a notice of this name is there. */
  boolean shows(String name) {
    return open.containsKey(name);
  }

  /** Whether there is a question. */
  boolean any() {
    return !open.isEmpty();
  }

  private static boolean within(JPanel notice) {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    return owner != null && SwingUtilities.isDescendingFrom(owner, notice);
  }

  /**
   * Gives the focus to the first choice of the newest question; it goes back when that is closed.
   */
  void focus() {
    if (any()) {
      focus(newest().buttons.getComponent(0));
    }
  }

  /** As the other one, to the choice that changes nothing: Enter does no harm by chance. */
  void focusHarmless() {
    if (any()) {
      focus(newest().harmless);
    }
  }

  private Notice newest() {
    return new ArrayList<>(open.values()).getLast();
  }

  private static void focus(Component choice) {
    choice.requestFocusInWindow();
  }

  /** One question. */
  private final class Notice extends Card {
    private final JPanel buttons = new JPanel(new WrappingRow(NoticeLayout.WITHIN_ROW));

    /** The choice of Escape; the first one where there is none. */
    private Component harmless;

    Notice(String name, String words, List<Choice> choices) {
      super(null);
      setName(name);
      WrappedText text = new WrappedText(words, ShellTexts.text("question"));
      text.setName(name + "-text");
      buttons.setOpaque(false);
      for (Choice each : choices) {
        JButton button = button(name, words, each);
        buttons.add(button);
        if (each.harmless() || harmless == null) {
          harmless = button;
        }
        if (each.harmless()) {
          onEscape(name, each);
        }
      }
      JLabel icon = new JLabel(Glyph.WARNING.icon(18, Palette.warning()));
      add(icon);
      add(text);
      add(buttons);
      setLayout(
          new NoticeLayout(icon, text, buttons, () -> Notices.this.getWidth() - 2 * margin()));
    }

    private void choose(String name, Choice choice) {
      close(name);
      // The focus has gone back by then: what the choice opens takes it from there.
      EventQueue.invokeLater(choice.run());
    }

    private JButton button(String name, String question, Choice choice) {
      JButton button = new JButton(choice.text());
      button.setName(name + "-" + choice.word());
      button.setToolTipText(choice.text());
      button.getAccessibleContext().setAccessibleName(choice.text());
      button.getAccessibleContext().setAccessibleDescription(question);
      button.addActionListener(event -> choose(name, choice));
      button.addFocusListener(focusKeeper);
      return button;
    }

    private void onEscape(String name, Choice choice) {
      getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
          .put(KeyStroke.getKeyStroke("ESCAPE"), "escape");
      getActionMap()
          .put(
              "escape",
              new AbstractAction() {
                @Override
                public void actionPerformed(ActionEvent event) {
                  choose(name, choice);
                }
              });
    }
  }
}
