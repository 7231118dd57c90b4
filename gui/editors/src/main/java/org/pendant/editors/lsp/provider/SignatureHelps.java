package org.pendant.editors.lsp.provider;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.eclipse.lsp4j.ParameterInformation;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.SignatureHelp;
import org.eclipse.lsp4j.SignatureInformation;
import org.eclipse.lsp4j.jsonrpc.messages.Tuple;
import org.pendant.editors.lsp.text.Document;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;

/** Signature helps: the call around the caret, and which of its arguments is being given. */
public final class SignatureHelps {
  private SignatureHelps() {}

  /** The call around {@code position}; empty outside of all calls. */
  public static Optional<SignatureHelp> at(Document document, Position position) {
    return document
        .analysis()
        .signatureHelp(document.offset(position))
        .map(
            help -> {
              // Behind the last parameter none is active: the protocol has no other word for it.
              int active = help.active() < 0 ? help.signature().parameters().size() : help.active();
              SignatureInformation signature = information(help.signature());
              signature.setActiveParameter(active);
              return new SignatureHelp(List.of(signature), 0, active);
            });
  }

  private static SignatureInformation information(Signature signature) {
    String head = signature.head();
    List<ParameterInformation> parameters = new ArrayList<>();
    int from = signature.name().length() + 1;
    for (Parameter parameter : signature.parameters()) {
      int end =
          from
              + parameter.name().length()
              + (parameter.required() ? 0 : 1 + parameter.defaultText().length());
      ParameterInformation information = new ParameterInformation();
      information.setLabel(Tuple.two(from, end));
      information.setDocumentation(parameter.described());
      parameters.add(information);
      from = end + 2;
    }
    SignatureInformation information = new SignatureInformation(head);
    if (!signature.documentation().isEmpty()) {
      information.setDocumentation(signature.documentation());
    }
    information.setParameters(parameters);
    return information;
  }
}
