package org.pendant.desktop.shell.chrome;

import static org.pendant.desktop.shell.chrome.ChromeTexts.text;

import java.util.concurrent.CompletableFuture;
import java.util.function.IntFunction;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JSlider;
import javax.swing.SwingUtilities;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.command.Reply;

/** Speed slider: how fast programs move the arm, 0 to 100 %. */
@SuppressWarnings("serial") // never written to a stream
final class SpeedSlider extends JPanel {
  private final JSlider slider = new JSlider(0, 100, 100);
  private final JLabel value = new JLabel("100 %");
  private int unanswered;
  private boolean following;

  /**
   * @param ask sets the speed in percent
   */
  SpeedSlider(IntFunction<CompletableFuture<Reply>> ask) {
    super(new MigLayout("insets 0, gap 4", "[][grow, 60:150:150][right]", "[center]"));
    slider.setName("speed-slider");
    slider.setToolTipText(text("speedOfProgramsAt0The"));
    slider.getAccessibleContext().setAccessibleName(text("speedOfProgramsInPercent"));
    JLabel title = new JLabel(text("speed"));
    title.setLabelFor(slider);
    value.setName("speed-value");
    value.setHorizontalAlignment(JLabel.RIGHT);
    add(title);
    add(slider, "growx, wmin 50");
    add(value, "wmin pref");
    slider.addChangeListener(
        event -> {
          value.setText(slider.getValue() + " %");
          slider.getAccessibleContext().setAccessibleDescription(value.getText());
          if (!following) {
            send(ask);
          }
        });
  }

  /** The speed in percent. */
  int percent() {
    return slider.getValue();
  }

  /** Chooses a speed in percent. */
  void choose(int percent) {
    slider.setValue(percent);
  }

  private void send(IntFunction<CompletableFuture<Reply>> ask) {
    unanswered++;
    var _ =
        ask.apply(slider.getValue()).thenRun(() -> SwingUtilities.invokeLater(() -> unanswered--));
  }

  /** Shows the controller's value, unless people are changing it. */
  void follow(double fraction) {
    int percent = (int) Math.round(100 * fraction);
    if (unanswered == 0 && !slider.getValueIsAdjusting() && percent != slider.getValue()) {
      following = true;
      slider.setValue(percent);
      following = false;
    }
  }
}
