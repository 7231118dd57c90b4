package org.pendant.protocols.xmlrpc;

import org.apache.xmlrpc.XmlRpcException;

/** XML-RPC fault: the server answered that it could not do what was asked. */
final class XmlRpcFault extends XmlRpcException {
  private static final long serialVersionUID = 1L;

  XmlRpcFault(int code, String text) {
    super(code, text);
  }
}
