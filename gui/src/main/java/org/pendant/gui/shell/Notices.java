package org.pendant.gui.shell;

import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import javax.swing.AbstractAction;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.pendant.gui.layout.WrappingRow;
import org.pendant.gui.shell.look.Card;
import org.pendant.gui.shell.look.Glyph;
import org.pendant.gui.shell.look.GlyphIcon;
import org.pendant.gui.shell.look.WrappedText;
import org.pendant.gui.workbench.Palette;

/** Questions above the views that can wait: the window is used meanwhile. */
@SuppressWarnings("serial") // never written to a stream
final class Notices extends JPanel {
  private final Map<String, Notice> open = new LinkedHashMap<>();
  private Component focusBefore;

  /**
   * Something to choose; every choice closes the notice.
   *
   * @param text of its button
   * @param harmless whether Escape may choose it
   */
  record Choice(String text, Runnable run, boolean harmless) {
    Choice(String text, Runnable run) {
      this(text, run, false);
    }

    /** Leaves everything as it is. */
    static Choice nothing(String text) {
      return new Choice(text, () -> {}, true);
    }
  }

  Notices() {
    super(new MigLayout("insets 0, gap 0, wrap 1, hidemode 3", "[grow, fill, 0::]", ""));
    setName("notices");
  }

  /** Tells something that must not pass unseen. */
  void tell(String name, String text) {
    ask(name, text, List.of(Choice.nothing("Close")));
  }

  /**
   * Asks, in place of an earlier question of the same name.
   *
   * @param name of the component
   */
  void ask(String name, String text, List<Choice> choices) {
    close(name);
    Notice notice = new Notice(name, text, choices);
    open.put(name, notice);
    add(notice, "gap 8 8 4 4, wmin 0");
    revalidate();
  }

  /** Takes a question back. */
  void close(String name) {
    Notice notice = open.remove(name);
    if (notice != null) {
      if (focusBefore != null && focusBefore.isShowing() && within(notice)) {
        focusBefore.requestFocusInWindow();
      }
      remove(notice);
      revalidate();
      repaint();
    }
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
      focusBefore = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
      new ArrayList<>(open.values()).getLast().buttons.getComponent(0).requestFocusInWindow();
    }
  }

  /** One question: its choices beside the text, or below it where there is no room. */
  private final class Notice extends Card {
    private final WrappedText text;
    private final JPanel buttons = new JPanel(new MigLayout("insets 0, gap 4"));
    private final transient MigLayout layout;
    private boolean beside = true;

    Notice(String name, String words, List<Choice> choices) {
      super(new MigLayout("insets 8 16 8 8, gap 8 0", "[][grow, fill, 0::][]", "[center][]"));
      layout = (MigLayout) getLayout();
      setName(name);
      text = new WrappedText(words, "Question");
      text.setName(name + "-text");
      buttons.setOpaque(false);
      for (Choice each : choices) {
        buttons.add(button(name, words, each));
        if (each.harmless()) {
          onEscape(name, each);
        }
      }
      add(new JLabel(GlyphIcon.of(Glyph.WARNING, 18, Palette::warning)), "cell 0 0");
      add(text, "cell 1 0, growx, wmin 0");
      add(buttons, place());
      addComponentListener(
          new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
              arrange();
            }
          });
    }

    private String place() {
      return beside ? "cell 2 0, wmin pref" : "cell 1 1, span 2, growx, wmin 0";
    }

    private void arrange() {
      int words = getFontMetrics(text.getFont()).stringWidth(text.getText());
      int least = Math.min(words, getWidth() / 3);
      boolean fits = least + width(buttons) < getWidth() * 4 / 5;
      if (fits != beside) {
        beside = fits;
        buttons.setLayout(fits ? new MigLayout("insets 0, gap 4") : new WrappingRow(4));
        layout.setComponentConstraints(buttons, place());
      }
      revalidate();
    }

    private static int width(JPanel row) {
      int width = 0;
      for (Component each : row.getComponents()) {
        width += each.getPreferredSize().width;
      }
      return width;
    }

    private void choose(String name, Choice choice) {
      close(name);
      choice.run().run();
    }

    private JButton button(String name, String question, Choice choice) {
      JButton button = new JButton(choice.text());
      button.setName(name + "-" + choice.text().replace(' ', '-').toLowerCase(Locale.ROOT));
      button.setToolTipText(choice.text());
      button.getAccessibleContext().setAccessibleName(choice.text());
      button.getAccessibleContext().setAccessibleDescription(question);
      button.addActionListener(event -> choose(name, choice));
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
