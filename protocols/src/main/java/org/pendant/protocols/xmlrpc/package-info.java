/**
 * Remote procedure calls of scripts, by XML-RPC. Open {@link
 * org.pendant.protocols.xmlrpc.XmlRpcConnector} first. The library writes and reads the XML; what
 * servers send is bounded and never becomes a Java object of their choice.
 */
package org.pendant.protocols.xmlrpc;
