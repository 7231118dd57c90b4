package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.EventQueue;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.util.OptionalLong;
import java.util.function.Consumer;
import javax.swing.JLabel;
import javax.swing.JScrollPane;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.layout.Parts;
import org.pendant.kit.theme.Palette;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantRun;
import org.pendant.script.vm.Program;

/** What a table of variants looks like. */
final class VariantTableTest {
  @Test
  void colourOfAVariantStandsOutFromASelectedRowOfTheSameColour() {
    Color selected = new Color(0x2C5D8F);
    BufferedImage picture = new BufferedImage(60, 30, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = picture.createGraphics();
    pen.setColor(selected);
    pen.fillRect(0, 0, 60, 30);
    VariantTable.Swatch swatch = new VariantTable.Swatch(selected);

    swatch.paintIcon(null, pen, 5, 5);

    int middle = 5 + swatch.getIconHeight() / 2;
    assertEquals(selected.getRGB(), picture.getRGB(5 + swatch.getIconWidth() / 2, middle));
    assertEquals(Palette.card().getRGB(), picture.getRGB(5, middle));
    assertEquals(Palette.card().getRGB(), picture.getRGB(4 + swatch.getIconWidth(), middle));
    assertEquals(selected.getRGB(), picture.getRGB(5 + swatch.getIconWidth(), middle));
  }

  /** A table whose variants all end with the same words. */
  private static VariantTable refusing(String why) {
    WhatIfPresenter.Source source =
        new WhatIfPresenter.Source() {
          @Override
          public VariantRun begin(OptionalLong frame, Variant variant, VariantLimits limits)
              throws RerunRefused {
            throw new RerunRefused(why);
          }

          @Override
          public void compile(Consumer<Program> then, Consumer<String> failed) {
            failed.accept(why);
          }
        };
    WhatIfPresenter presenter =
        new WhatIfPresenter(
            source,
            () -> new WhatIfPresenter.Start(OptionalLong.empty(), "run", ""),
            Runnable::run,
            Runnable::run,
            () -> {});
    VariantTableModel model =
        new VariantTableModel(presenter, () -> PoseForm.STANDARD, (line, edited) -> "line " + line);
    VariantTable table = new VariantTable(presenter, model, new JLabel());
    presenter.run();
    model.show();
    return table;
  }

  @Test
  void resultIsWholeWhereThereIsRoomAndWholeInItsTipWhereThereIsNot() throws Exception {
    String said = "C157A4 protective stop at 12.344 s: the wrist 2 has hit \"table\": 0.00075 m";
    String why = "C157A4 protective stop at 12.344 s: the wrist 2 has hit \"table\": 0.75 mm";
    EventQueue.invokeAndWait(
        () -> {
          VariantTable table = refusing(said);
          int needed = table.getFontMetrics(table.getFont()).stringWidth(why);

          table.setSize(1600, 100);
          table.doLayout();
          assertTrue(result(table).width >= needed, () -> result(table) + " of " + needed);

          table.setSize(table.getPreferredSize());
          table.doLayout();
          Rectangle cell = result(table);
          assertTrue(cell.width < needed, () -> cell + " of " + needed);
          MouseEvent over =
              new MouseEvent(table, MouseEvent.MOUSE_MOVED, 0, 0, cell.x + 5, cell.y + 5, 0, false);
          assertEquals(why, table.getToolTipText(over));
        });
  }

  @Test
  void resultIsWholeInADockThatIsSoNarrowThatPeopleHaveToScroll() throws Exception {
    String why = "C157A4 protective stop at 12.344 s: the wrist 2 has hit \"table\"";
    EventQueue.invokeAndWait(
        () -> {
          VariantTable table = refusing(why);
          JScrollPane dock = new JScrollPane(table);
          dock.setSize(300, 200);
          Parts.layOut(dock);
          int needed = table.getFontMetrics(table.getFont()).stringWidth(why);
          assertTrue(result(table).width >= needed, () -> result(table) + " of " + needed);
        });
  }

  private static Rectangle result(VariantTable table) {
    return table.getCellRect(0, VariantTableModel.RESULT, false);
  }
}
