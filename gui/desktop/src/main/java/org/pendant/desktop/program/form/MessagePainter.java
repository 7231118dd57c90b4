package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.List;
import org.pendant.kit.theme.Palette;
import org.pendant.project.program.ActionStep;

/** Message painter: draws a popup as operators will see it. */
final class MessagePainter {
  private final Graphics2D pen;
  private final int width;
  private final int height;

  MessagePainter(Graphics2D pen, int width, int height) {
    this.pen = pen;
    this.width = width;
    this.height = height;
  }

  void paint(Sketch.Message message) {
    int wide = Math.min(width - 2, UIScale.scale(320));
    int x = (width - wide) / 2;
    RoundRectangle2D frame =
        new RoundRectangle2D.Double(x, 1, wide, height - 2.0, UIScale.scale(10), UIScale.scale(10));
    Color color = color(message.kind());
    pen.setColor(Palette.tint(color, 0.08));
    pen.fill(frame);
    pen.setColor(Palette.line());
    pen.setStroke(new BasicStroke(UIScale.scale(1f)));
    pen.draw(frame);
    int pad = UIScale.scale(12);
    int sign = UIScale.scale(20);
    pen.setColor(color);
    pen.fill(new Ellipse2D.Double(x + pad, pad, sign, sign));
    Font font = pen.getFont();
    pen.setFont(font.deriveFont(Font.BOLD));
    FontMetrics metrics = pen.getFontMetrics();
    pen.setColor(Palette.card());
    String mark = message.kind() == ActionStep.PopupKind.MESSAGE ? "i" : "!";
    pen.drawString(
        mark,
        x + pad + (sign - metrics.stringWidth(mark)) / 2,
        pad + sign / 2 + metrics.getAscent() * 2 / 5);
    int left = x + 2 * pad + sign;
    pen.setColor(color);
    pen.drawString(title(message.kind()), left, pad + sign / 2 + metrics.getAscent() * 2 / 5);
    pen.setFont(font);
    int button = metrics.getHeight() + UIScale.scale(8);
    body(message.text(), left, pad + sign + UIScale.scale(6), x + wide - pad - left, button);
    button(message.halts() ? text("endProgram") : text("continue"), x + wide - pad, button, color);
  }

  private void body(String text, int left, int top, int room, int button) {
    FontMetrics metrics = pen.getFontMetrics();
    pen.setColor(text.isBlank() ? Palette.quiet() : foreground());
    int y = top + metrics.getAscent();
    int lowest = height - button - UIScale.scale(14);
    for (String line : wrapped(text.isBlank() ? text("noTextYet") : text, metrics, room)) {
      if (y > lowest) {
        break;
      }
      pen.drawString(line, left, y);
      y += metrics.getHeight();
    }
  }

  private static Color foreground() {
    return Palette.dark() ? Color.WHITE : Color.BLACK;
  }

  private static List<String> wrapped(String text, FontMetrics metrics, int room) {
    List<String> lines = new ArrayList<>();
    for (String paragraph : text.split("\n", -1)) {
      StringBuilder line = new StringBuilder();
      for (String word : paragraph.split(" ", -1)) {
        String longer = line.isEmpty() ? word : line + " " + word;
        if (!line.isEmpty() && metrics.stringWidth(longer) > room) {
          lines.add(line.toString());
          line.setLength(0);
          line.append(word);
        } else {
          line.setLength(0);
          line.append(longer);
        }
      }
      lines.add(line.toString());
    }
    return lines;
  }

  private void button(String text, int right, int tall, Color color) {
    FontMetrics metrics = pen.getFontMetrics();
    int wide = metrics.stringWidth(text) + UIScale.scale(20);
    int y = height - tall - UIScale.scale(8);
    pen.setColor(color);
    pen.draw(
        new RoundRectangle2D.Double(
            right - wide, y, wide, tall, UIScale.scale(6), UIScale.scale(6)));
    pen.drawString(
        text,
        right - wide + UIScale.scale(10),
        y + (tall + metrics.getAscent() - metrics.getDescent()) / 2);
  }

  private static Color color(ActionStep.PopupKind kind) {
    return switch (kind) {
      case MESSAGE -> Palette.accent();
      case WARNING -> Palette.warning();
      case ERROR -> Palette.error();
    };
  }

  private static String title(ActionStep.PopupKind kind) {
    return switch (kind) {
      case MESSAGE -> text("message");
      case WARNING -> text("warning");
      case ERROR -> text("error");
    };
  }
}
