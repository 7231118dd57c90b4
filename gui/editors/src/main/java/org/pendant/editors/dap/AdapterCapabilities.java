package org.pendant.editors.dap;

import org.eclipse.lsp4j.debug.Capabilities;

/** Adapter capabilities: what a client is told that it can ask for. */
final class AdapterCapabilities {
  private AdapterCapabilities() {}

  static Capabilities all(ClientForm form) {
    Capabilities all = new Capabilities();
    all.setSupportsConfigurationDoneRequest(true);
    all.setSupportsConditionalBreakpoints(true);
    all.setSupportsHitConditionalBreakpoints(true);
    all.setSupportsLogPoints(true);
    all.setSupportsBreakpointLocationsRequest(true);
    all.setExceptionBreakpointFilters(ExceptionFilters.all(form));
    all.setSupportsStepBack(true);
    all.setSupportsSteppingGranularity(true);
    all.setSupportsDataBreakpoints(true);
    all.setSupportsFunctionBreakpoints(true);
    all.setSupportsExceptionInfoRequest(true);
    all.setSupportsTerminateThreadsRequest(true);
    all.setSupportsGotoTargetsRequest(true);
    all.setSupportsCancelRequest(true);
    all.setSupportsLoadedSourcesRequest(true);
    all.setSupportsCompletionsRequest(true);
    all.setCompletionTriggerCharacters(new String[] {"."});
    all.setSupportsEvaluateForHovers(true);
    all.setSupportsSetVariable(true);
    all.setSupportsSetExpression(true);
    all.setSupportsTerminateRequest(true);
    all.setSupportTerminateDebuggee(true);
    all.setSupportsRestartRequest(true);
    all.setSupportsDelayedStackTraceLoading(true);
    return all;
  }
}
