package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

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
          new FormBuilder(context, "unknown", text("unknownNode"), text("cameFromAnImportedFileIt"))
              .quiet("element", text("element", element))
              .add(
                  new Item.Code(
                      "data", text("data"), String.join("\n", data), false, Optional.empty()))
              .build();
    };
  }

  private static NodeForm contributed(FormContext context, ForeignStep.Contributed step) {
    return about(context, step)
        .part(text("scriptInItsPlace"))
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
        .part(text("data"))
        .add(new Item.Code("data", "", String.join("\n", step.data()), false, Optional.empty()))
        .build();
  }

  private static FormBuilder about(FormContext context, ForeignStep.Contributed step) {
    if (ExternalControl.is(step)) {
      return new FormBuilder(
              context, "external-control", ExternalControl.TYPE, text("aboutExternalControl"))
          .quiet(
              "driver",
              text("asksInstallationExternalControl", context.installation().controlHost().text()));
    }
    return new FormBuilder(
            context, "contributed", text("contributedNode"), text("belongsToAUrcapItsData"))
        .quiet(
            "source",
            (step.source().isEmpty() ? text("unknownSource") : step.source())
                + (step.type().isEmpty() ? "" : ", " + step.type()));
  }

  /** The lines of a text; none of an empty one. */
  static List<String> lines(String text) {
    return text.isEmpty() ? List.of() : List.of(text.split("\n", -1));
  }
}
