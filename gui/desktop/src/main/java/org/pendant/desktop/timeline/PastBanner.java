package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.awt.Color;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.pendant.kit.theme.Palette;

/**
 * Past banner: stands below the views while they show the past, so that it is not taken for the
 * present.
 */
@SuppressWarnings("serial") // never written to a stream
public final class PastBanner extends JPanel {
  private final transient LookBack lookBack;
  private final transient RecordedText text;
  private final JLabel words = new JLabel();
  private final JButton live = new JButton(text("live"));
  private final JButton recorded = new JButton(text("showTheTextThatRan"));

  /** Hidden until the user looks back. */
  public PastBanner(LookBack lookBack, RecordedText text) {
    super(
        new MigLayout(
            "insets 2 12 2 12, gap 8, hidemode 3", "[grow, fill, 0::][][]", "[grow, center]"));
    this.lookBack = lookBack;
    this.text = text;
    setName("past-banner");
    words.setName("past-banner-words");
    live.setName("past-banner-live");
    live.addActionListener(event -> lookBack.live());
    recorded.setName("past-banner-text");
    recorded.setToolTipText(text("theProgramHasChangedSinceOr"));
    recorded.addActionListener(event -> text.open(this));
    for (JButton each : List.of(recorded, live)) {
      each.putClientProperty("FlatLaf.style", "margin: 0,8,0,8");
    }
    add(words, "wmin 0");
    add(recorded);
    add(live);
    // Only where nothing else takes the key.
    getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW).put(KeyStroke.getKeyStroke("ESCAPE"), "live");
    getActionMap()
        .put(
            "live",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                lookBack.live();
              }

              @Override
              public boolean isEnabled() {
                return lookBack.back();
              }
            });
    setVisible(false);
  }

  /**
   * Shows what is looked at.
   *
   * @param elsewhere whether the program that ran then is not what is open now
   */
  public void refresh(boolean elsewhere) {
    setVisible(lookBack.back());
    text.show(lookBack.back() ? lookBack.program() : Optional.empty(), lookBack.past());
    if (!lookBack.back()) {
      return;
    }
    Color color = Palette.accent();
    setBackground(Palette.tint(color, 0.22));
    setBorder(BorderFactory.createMatteBorder(1, 0, 1, 0, color));
    if (!words.getText().equals(lookBack.banner())) {
      words.setText(lookBack.banner());
      words.setToolTipText(lookBack.banner());
      words.getAccessibleContext().setAccessibleName(lookBack.banner());
    }
    live.setText(lookBack.ofFile() ? text("backToTheRobot") : text("live"));
    live.setToolTipText(text("backToWhatTheRobotDoes"));
    live.getAccessibleContext().setAccessibleName(live.getText());
    recorded.setVisible(elsewhere);
  }
}
