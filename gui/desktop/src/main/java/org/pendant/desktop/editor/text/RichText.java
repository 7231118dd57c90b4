package org.pendant.desktop.editor.text;

import static org.pendant.desktop.editor.text.ScriptTexts.text;

import org.pendant.desktop.unit.PoseForm;
import org.pendant.kit.theme.Markup;
import org.pendant.language.service.Completion;
import org.pendant.language.service.Hover;
import org.pendant.language.service.Quantity;
import org.pendant.language.service.SignatureHelp;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.source.ByteText;

/** Rich text: what popups say, in the HTML that labels understand. */
public final class RichText {
  private static final int WIDTH_PX = 250;

  private static final String CODE = "<span style=\"font-family: JetBrains Mono\">";

  private RichText() {}

  /** What is known about a name: its head as code, and sentences. */
  public static String of(Hover hover) {
    StringBuilder html = new StringBuilder(code(hover.head()));
    for (String line : hover.text().split("\n", -1)) {
      if (!line.isEmpty()) {
        html.append("<br>").append(escaped(line));
      }
    }
    return page(html.toString());
  }

  /**
   * The value of a variable, and below it what is known about its name.
   *
   * @param form in which a pose is shown, below its value
   */
  public static String of(String name, String value, PoseForm form, Hover about) {
    String below = of(about).replaceFirst("^<html><body[^>]*>", "").replace("</body></html>", "");
    String pose =
        PoseText.read(value)
            .map(each -> escaped(form.words(each)).replace("\n", "<br>") + "<br>")
            .orElse("");
    return page("<b>" + code(name + " = " + value) + "</b><br>" + pose + below);
  }

  /** Plain text, broken into lines where it is long. */
  public static String of(String text) {
    return page(escaped(text));
  }

  /** Plain text, as it is broken into lines. */
  public static String lines(String text) {
    return "<html><body>" + Markup.escaped(text).replace("\n", "<br>") + "</body></html>";
  }

  /** A number, in the units that people think in as well. */
  public static String of(Quantity quantity, PoseForm form) {
    return page(CODE + escaped(QuantityText.of(quantity, form)) + "</span>");
  }

  /** The call that is being written, with the present parameter in bold and its unit. */
  public static String of(SignatureHelp help) {
    Signature signature = help.signature();
    StringBuilder html = new StringBuilder();
    StringBuilder head = new StringBuilder(escaped(signature.name())).append('(');
    for (int i = 0; i < signature.parameters().size(); i++) {
      Parameter parameter = signature.parameters().get(i);
      String text = parameter.name() + (parameter.required() ? "" : "=" + parameter.defaultText());
      head.append(i == 0 ? "" : ", ");
      head.append(i == help.active() ? "<b><u>" + escaped(text) + "</u></b>" : escaped(text));
    }
    html.append(CODE).append(head).append(")</span>");
    help.activeParameter()
        .ifPresent(parameter -> html.append("<br>").append(escaped(parameter.described())));
    String sentence = firstSentence(signature.documentation());
    if (!sentence.isEmpty()) {
      html.append("<br>").append(escaped(sentence));
    }
    return page(html.toString());
  }

  /** What stands beside a completion: head with units, and its sentence. */
  public static String of(Completion completion) {
    StringBuilder html = new StringBuilder(code(completion.label()));
    if (!completion.detail().isEmpty()) {
      html.append("<br>").append(escaped(completion.detail()));
    }
    if (!completion.documentation().isEmpty()) {
      html.append("<br><br>").append(escaped(completion.documentation()));
    }
    return page(html.toString());
  }

  /** A problem's message. */
  public static String of(Problem problem) {
    String word = text(problem.isError() ? "error" : "warning");
    return page("<b>" + word + " </b>" + escaped(problem.message()));
  }

  /** {@code html} as a whole page, broken into lines where it is long. */
  static String page(String html) {
    String plain = html.replaceAll("<[^>]*>", "");
    String width = plain.length() > 70 ? " style=\"width: " + WIDTH_PX + "px\"" : "";
    return "<html><body" + width + ">" + html + "</body></html>";
  }

  private static String firstSentence(String text) {
    int end = text.indexOf(". ");
    return end < 0 ? text : text.substring(0, end + 1);
  }

  private static String code(String text) {
    return CODE + escaped(text) + "</span>";
  }

  private static String escaped(String text) {
    return Markup.escaped(ByteText.decoded(text));
  }
}
