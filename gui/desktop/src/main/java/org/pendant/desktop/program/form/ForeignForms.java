package org.pendant.desktop.program.form;

import java.util.List;
import java.util.Optional;
import org.pendant.project.program.ExternalControl;
import org.pendant.project.program.ForeignStep;

/** Foreign forms: those of nodes that Pendant does not know. */
final class ForeignForms {
  private ForeignForms() {}

  static NodeForm of(FormContext context, ForeignStep step) {
    return switch (step) {
      case ForeignStep.Contributed contributed -> contributed(context, contributed);
      case ForeignStep.Unknown(String element, List<String> data) ->
          new FormBuilder(
                  context,
                  "unknown",
                  "Unknown node",
                  "Came from an imported file. It is kept as it was and does nothing.")
              .quiet("element", "Element: " + element)
              .add(new Item.Code("data", "Data", String.join("\n", data), false, Optional.empty()))
              .build();
    };
  }

  private static NodeForm contributed(FormContext context, ForeignStep.Contributed step) {
    return about(context, step)
        .part("Script in its place")
        .add(
            new Item.Code(
                "stub",
                "",
                String.join("\n", step.stub()),
                true,
                Optional.of(
                    text ->
                        context.with(
                            new ForeignStep.Contributed(
                                step.source(), step.type(), step.data(), lines(text))))))
        .part("Data")
        .add(new Item.Code("data", "", String.join("\n", step.data()), false, Optional.empty()))
        .build();
  }

  private static FormBuilder about(FormContext context, ForeignStep.Contributed step) {
    if (ExternalControl.is(step)) {
      return new FormBuilder(
              context,
              "external-control",
              ExternalControl.TYPE,
              "Hands the arm over to a driver: when the program starts, that is asked for the"
                  + " script that runs here.")
          .quiet(
              "driver",
              "Asks "
                  + context.installation().controlHost().text()
                  + " (Installation, External Control)");
    }
    return new FormBuilder(
            context,
            "contributed",
            "Contributed node",
            "Belongs to a URCap. Its data are kept; the script below runs in its place.")
        .quiet(
            "source",
            (step.source().isEmpty() ? "Unknown source" : step.source())
                + (step.type().isEmpty() ? "" : ", " + step.type()));
  }

  /** The lines of a text; none of an empty one. */
  static List<String> lines(String text) {
    return text.isEmpty() ? List.of() : List.of(text.split("\n", -1));
  }
}
