package org.pendant.desktop.shell.chrome;

import com.formdev.flatlaf.util.UIScale;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Locale;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.kit.theme.Palette;

/** Status line: the last thing that was told, and how punctual the frames are. */
@SuppressWarnings("serial") // never written to a stream
public final class StatusLine extends JPanel {
  private final JLabel told = new JLabel(" ");
  private final JButton whole = new JButton("More");
  private final JLabel punctual = new JLabel(" ");
  private long frames;
  private long late;
  private int calls;
  private Consumer<String> alsoTold = text -> {};

  /**
   * Nothing was told yet.
   *
   * @param showWhole shows a notice that is cut off here as a whole
   */
  public StatusLine(Consumer<String> showWhole) {
    super(
        new MigLayout(
            "insets 2 12 2 12, gap 16, hidemode 3", "[0::, fill]8[][grow][right]", "[center]"));
    told.setName("status-text");
    told.getAccessibleContext().setAccessibleName("Last notice");
    punctual.setName("status-frames");
    punctual.getAccessibleContext().setAccessibleName("Lateness of frames");
    whole.setName("status-more");
    whole.setVisible(false);
    whole.setToolTipText("Shows the notice as a whole");
    whole.getAccessibleContext().setAccessibleName("Show the notice as a whole");
    whole.putClientProperty("JButton.buttonType", "toolBarButton");
    whole.putClientProperty("FlatLaf.style", "margin: 0,4,0,4");
    whole.addActionListener(event -> showWhole.accept(text()));
    add(told, "growx, wmin 0");
    add(whole);
    add(punctual, "cell 3 0, wmin pref");
    addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            fit();
          }
        });
  }

  /** Shows a sentence, until the next one. */
  public void tell(String text) {
    told.setText(text.isEmpty() ? " " : text);
    told.setToolTipText(text);
    fit();
    alsoTold.accept(text);
  }

  /** Has {@code listener} hear from now on what is told. */
  public void alsoTell(Consumer<String> listener) {
    alsoTold = listener;
  }

  /** The last notice; empty if there was none. */
  public String text() {
    return told.getText().strip();
  }

  /** Offers to show the whole where a part of it is cut off. */
  private void fit() {
    int others = punctual.getPreferredSize().width + UIScale.scale(60);
    whole.setVisible(told.getPreferredSize().width + others > getWidth());
  }

  /**
   * Shows how punctual the frames are; called 30 times a second.
   *
   * @param behindS by how much robot time has fallen behind the wall clock, s
   * @param held whether a debugger has paused the program
   */
  public void refresh(Lateness lateness, double behindS, boolean held) {
    calls++;
    if (calls % 60 != 1) {
      return;
    }
    if (held) {
      // Frames are not due then.
      punctual.setText(" ");
      return;
    }
    punctual.setForeground(Palette.quiet());
    punctual.setText(text(lateness, frames, late));
    punctual.setToolTipText(explanation(lateness, behindS));
    frames = lateness.frames();
    late = lateness.lateFrames();
  }

  /** What the numbers mean, and what there is beside them. */
  static String explanation(Lateness lateness, double behindS) {
    return String.format(
        Locale.ROOT,
        "Frames of robot time that began more than 1 ms late in the last two seconds; the"
            + " latest so far was %.1f ms late, and robot time is %.2f s behind the wall clock",
        lateness.worstNs() / 1e6,
        behindS);
  }

  /** How punctual the frames were since there were {@code frames}, {@code late} of them late. */
  static String text(Lateness lateness, long frames, long late) {
    long count = lateness.frames() - frames;
    if (count <= 0) {
      return " ";
    }
    return String.format(
        Locale.ROOT, "500 Hz, %.1f %% late", 100.0 * (lateness.lateFrames() - late) / count);
  }
}
