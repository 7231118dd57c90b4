package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import net.miginfocom.swing.MigLayout;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.kit.layout.InnerScroll;
import org.pendant.kit.layout.TitledCard;
import org.pendant.kit.text.Messages;
import org.pendant.kit.theme.Palette;

/** Device card: the devices of the cell, what they are at, and parts for them to hold. */
final class DeviceCard {

  /** Of the width that fits, the part that a part has. */
  private static final double PART = 0.4;

  private final TitledCard card = new TitledCard("cell", text("cell"), "[grow,fill,0::]");
  private final JPanel table =
      new JPanel(new MigLayout("insets 0, gap 12 2, wrap 2", "[grow, 0:180:][right]"));
  private final Function<Command, CompletableFuture<Reply>> submit;
  private final Consumer<String> tell;
  private final Supplier<DisplayUnit> length;
  private final List<Line> lines = new ArrayList<>();
  private List<DeviceState> shown = List.of();
  private DisplayUnit shownIn = DisplayUnit.MILLIMETRE;

  /** What is shown of a device. */
  private static final class Line {
    private final JLabel name = new JLabel();
    private final JLabel doing = new JLabel();
    private final JCheckBox part = new JCheckBox(text("partBox"));
    private final DeviceSignals signals;

    private Line(DeviceSignals signals) {
      this.signals = signals;
    }
  }

  /**
   * A card without devices.
   *
   * @param submit takes what people want
   * @param tell tells why that was refused
   * @param length in which people read lengths now
   */
  DeviceCard(
      Function<Command, CompletableFuture<Reply>> submit,
      Consumer<String> tell,
      Supplier<DisplayUnit> length) {
    this.submit = submit;
    this.tell = tell;
    this.length = length;
    table.setOpaque(false);
    card.add(table);
    card.setVisible(false);
  }

  JComponent component() {
    return card;
  }

  void refresh(ControllerState state) {
    DisplayUnit now = length.get();
    if (!state.devices().equals(shown) || now != shownIn) {
      boolean others = !names(state.devices()).equals(names(shown));
      shown = state.devices();
      shownIn = now;
      if (others) {
        rebuild();
      }
      for (int i = 0; i < lines.size(); i++) {
        show(lines.get(i), DeviceRow.of(shown.get(i), now));
        lines.get(i).signals.show(shown.get(i));
      }
    }
    for (Line line : lines) {
      line.doing.setForeground(Palette.quiet());
    }
  }

  private static List<String> names(List<DeviceState> devices) {
    return devices.stream().map(DeviceState::name).toList();
  }

  private void rebuild() {
    card.setVisible(!shown.isEmpty());
    lines.clear();
    table.removeAll();
    for (DeviceState device : shown) {
      Line line = new Line(new DeviceSignals(this::set, tell));
      DeviceRow row = DeviceRow.of(device, shownIn);
      line.name.setText(row.name());
      line.name.setToolTipText(row.kind());
      line.name.setName("device-" + row.name());
      line.doing.setName("device-" + row.name() + "-doing");
      line.part.setOpaque(false);
      TitledCard.named(
          line.part,
          "device-" + row.name() + "-part",
          switch (row.box()) {
            case PRESS -> text("pressByHand", row.name());
            case ONLINE -> text("haveOnTheNetwork", row.name());
            case PART, NONE -> text("putAPartWhereGrips", row.name());
          });
      line.part.setText(row.box().text());
      line.part.setVisible(row.box() != DeviceRow.Box.NONE);
      line.part.addActionListener(
          event -> {
            boolean on = line.part.isSelected();
            if (row.box() == DeviceRow.Box.ONLINE) {
              set(device.name() + "." + DeviceSignals.ONLINE, on ? 1 : 0);
            } else {
              submit(
                  new WorldCommand.PutPart(device.name(), on ? PART * device.maxPartWidthM() : 0));
            }
          });
      table.add(line.name, "wmin 0");
      table.add(line.part);
      table.add(line.doing, "span 2, growx, w 0:100:, gapbottom 4");
      if (!device.signals().isEmpty()) {
        line.signals.show(device);
        table.add(
            InnerScroll.of(
                new JScrollPane(
                    new DeviceSignalTable("device-" + row.name() + "-signals", line.signals))),
            "span 2, growx, w 0:100:, gapbottom 4");
      }
      lines.add(line);
    }
    card.revalidate();
    card.repaint();
  }

  private void set(String signal, int value) {
    submit(new WorldCommand.SetSignal(signal, value));
  }

  private void submit(Command command) {
    var _ =
        submit
            .apply(command)
            .thenAccept(
                reply ->
                    reply
                        .complaint()
                        .ifPresent(why -> EventQueue.invokeLater(() -> tell.accept(why))));
  }

  private static void show(Line line, DeviceRow row) {
    line.part.setSelected(row.boxOn());
    if (!row.doing().equals(line.doing.getText())) {
      line.doing.setText(row.doing());
      line.doing.setToolTipText(Messages.told(row.name(), row.doing()));
    }
  }
}
