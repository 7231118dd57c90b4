package org.pendant.desktop.waveform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTextField;
import org.junit.jupiter.api.Test;

/** The fields and buttons above waveforms. */
final class WaveformBarTest {
  @Test
  void fieldForThePeriodKeepsRoomForItsNumberInALowNarrowDock() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          WaveformDraft draft = new WaveformDraft(new WaveformDraft.Steps(WaveSheet.EMPTY));
          WaveformBar bar =
              new WaveformBar(
                  draft,
                  new WaveformCanvas(draft, new WaveformPainter(name -> name), () -> ""),
                  words -> {});
          List<JButton> spared = List.of(new JButton("Save\u2026"), new JButton("Open\u2026"));
          spared.forEach(bar::add);
          bar.addValue();
          bar.keepToOneRow(spared);
          for (int width : new int[] {900, 480, 420}) {
            bar.setSize(width, 40);
            bar.getComponentListeners()[0].componentResized(null);
            bar.doLayout();
            for (Component each : bar.getComponents()) {
              each.doLayout();
            }
            JTextField period = period(bar);
            assertEquals(period.getPreferredSize().width, period.getWidth(), "at " + width);
            assertTrue(period.isVisible());
          }
        });
  }

  private static JTextField period(Container in) {
    return Arrays.stream(in.getComponents())
        .flatMap(each -> each instanceof JPanel group ? Stream.of(group.getComponents()) : null)
        .filter(each -> "waveform-period".equals(each.getName()))
        .map(JTextField.class::cast)
        .findFirst()
        .orElseThrow();
  }
}
