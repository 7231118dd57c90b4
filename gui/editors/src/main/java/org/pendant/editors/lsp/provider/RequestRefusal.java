package org.pendant.editors.lsp.provider;

import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;

/** Request refusal: the answer to a request that is understood but cannot be carried out. */
public final class RequestRefusal {
  private RequestRefusal() {}

  /** A refusal for a reason to show to the user. */
  public static ResponseErrorException of(String reason) {
    return new ResponseErrorException(
        new ResponseError(ResponseErrorCode.RequestFailed, reason, null));
  }

  /** The answer to a request whose parameters make no sense. */
  public static ResponseErrorException ofParameters(String reason) {
    return new ResponseErrorException(
        new ResponseError(ResponseErrorCode.InvalidParams, reason, null));
  }
}
