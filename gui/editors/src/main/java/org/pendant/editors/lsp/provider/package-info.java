/** The answers to the requests of the protocol: a class for each family of them. */
package org.pendant.editors.lsp.provider;
