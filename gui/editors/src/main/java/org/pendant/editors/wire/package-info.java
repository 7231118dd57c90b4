/**
 * What the language server and the debug adapter have in common on the wire: the framing of
 * JSON-RPC messages, bounded.
 */
package org.pendant.editors.wire;
